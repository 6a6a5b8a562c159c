#include "lessons/text.h"

namespace halfspace {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";

unsigned byteAt(std::string_view text, std::size_t index) { return static_cast<unsigned char>(text[index]); }

/// How many bytes a character takes that begins with this one; 0: none begins so.
std::size_t lengthFrom(unsigned first) {
  if (first < 0x80)
    return 1;
  if (first >= 0xC2 && first < 0xE0)
    return 2;
  if (first >= 0xE0 && first < 0xF0)
    return 3;
  return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

/// Whether Unicode has this character, and needs so many bytes for it.
bool isWellFormed(const Character &character) {
  const auto &[code, length] = character;
  const bool isHalfAPair = code >= 0xD800 && code < 0xE000;
  return !isHalfAPair && (length < 3 || code >= 0x800) && (length < 4 || code >= 0x10000) && code < 0x110000;
}

bool isControl(char32_t code) {
  return (code < 0x20 && code != '\t' && code != '\n') || (code >= 0x7F && code < 0xA0);
}

/// Marks that turn the direction of what follows: a sentence could be made to read as another.
bool turnsDirection(char32_t code) {
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

Character firstCharacter(std::string_view text) {
  const std::size_t length = text.empty() ? 0 : lengthFrom(byteAt(text, 0));
  if (length == 0 || length > text.size())
    return {};
  Character character{length == 1 ? byteAt(text, 0) : byteAt(text, 0) & (0x7FU >> length), length};
  for (std::size_t i = 1; i < length; ++i) {
    if (!continuesCharacter(text[i]))
      return {};
    character.code = character.code << 6U | (byteAt(text, i) & 0x3FU);
  }
  return isWellFormed(character) ? character : Character{};
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
    const auto [code, length] = firstCharacter(bytes.substr(at));
    if (length == 0 || (code != '\r' && isControl(code)))
      return at;
    at += length;
  }
  return {};
}

std::string printable(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const auto [code, length] = firstCharacter(text);
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
  while (end > 0 && continuesCharacter(text[end]))
    --end;
  return std::string(text.substr(0, end)) + "…";
}

} // namespace halfspace
