#include "lessons/text.h"

namespace halfspace {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";

unsigned byteAt(std::string_view text, std::size_t index) { return static_cast<unsigned char>(text[index]); }

bool continues(std::string_view text, std::size_t index) {
  return index < text.size() && (byteAt(text, index) & 0xC0U) == 0x80U;
}

/// The number of the character that a text begins with. Requires characterLength(text) > 0.
unsigned codePoint(std::string_view text) {
  const std::size_t length = characterLength(text);
  unsigned code = length == 1 ? byteAt(text, 0) : byteAt(text, 0) & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i)
    code = code << 6U | (byteAt(text, i) & 0x3FU);
  return code;
}

bool isControl(unsigned code) {
  return (code < 0x20 && code != '\t' && code != '\n') || (code >= 0x7F && code < 0xA0);
}

/// Marks that turn the direction of what follows: a sentence could be made to read as another.
bool turnsDirection(unsigned code) {
  return code == 0x200E || code == 0x200F || code == 0x061C || (code >= 0x202A && code <= 0x202E) ||
         (code >= 0x2066 && code <= 0x2069);
}

} // namespace

std::vector<std::string_view> partsOf(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> parts;
  for (auto end = text.find_first_of(separators); end != std::string_view::npos;
       end = text.find_first_of(separators)) {
    parts.push_back(trimmed(text.substr(0, end)));
    text.remove_prefix(end + 1);
  }
  parts.push_back(trimmed(text));
  return parts;
}

std::string replacedAll(std::string text, std::string_view from, std::string_view to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

std::size_t characterLength(std::string_view text) {
  if (text.empty())
    return 0;
  const unsigned first = byteAt(text, 0);
  if (first < 0x80)
    return 1;
  const std::size_t length = first >= 0xC2 && first < 0xE0   ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
  for (std::size_t i = 1; i < length; ++i)
    if (!continues(text, i))
      return 0;
  const unsigned second = length > 2 ? byteAt(text, 1) : 0;
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool halfAPair = first == 0xED && second >= 0xA0;
  const bool beyondUnicode = first == 0xF4 && second >= 0x90;
  return overlong || halfAPair || beyondUnicode ? 0 : length;
}

std::string utf8(unsigned code) {
  const auto last = [code](unsigned shift) { return static_cast<char>(0x80U | (code >> shift & 0x3FU)); };
  std::string text;
  if (code < 0x80)
    text = {static_cast<char>(code)};
  else if (code < 0x800)
    text = {static_cast<char>(0xC0U | code >> 6U), last(0)};
  else if (code < 0x10000)
    text = {static_cast<char>(0xE0U | code >> 12U), last(6), last(0)};
  else if (code < 0x110000)
    text = {static_cast<char>(0xF0U | code >> 18U), last(12), last(6), last(0)};
  return characterLength(text) == text.size() ? text : "";
}

std::optional<std::size_t> firstNoText(std::string_view bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const std::string_view rest = bytes.substr(at);
    const std::size_t length = characterLength(rest);
    if (length == 0 || (rest.front() != '\r' && isControl(codePoint(rest))))
      return at;
    at += length;
  }
  return {};
}

std::string printable(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t length = characterLength(text);
    const unsigned code = length == 0 ? 0 : codePoint(text);
    if (isControl(code) || turnsDirection(code))
      shown += replacement;
    else
      shown += text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return shown;
}

std::string shortened(std::string_view text) {
  constexpr std::size_t longest = 40;
  if (text.size() <= longest)
    return std::string(text);
  std::size_t end = longest;
  // Never in the middle of a UTF-8 character.
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
    --end;
  return std::string(text.substr(0, end)) + "…";
}

} // namespace halfspace
