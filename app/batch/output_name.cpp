#include "app/batch/output_name.h"

#include "lessons/files/numbered_file.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <utility>

namespace halfspace {
namespace {

/// More digits have no use in a name.
constexpr std::size_t mostDigits = 9;

/// frames/{frame:04}.png for frames/%04d.png.
std::string withFramePlace(const std::string &typed) {
  const auto numbered = parseNumberedFile(typed);
  if (!numbered)
    return typed;
  return numbered->before + "{" + std::string(framePlace) + ":0" + std::to_string(numbered->digits) + "}" +
         numbered->behind;
}

std::string withLeadingZeros(std::string number, std::size_t digits) {
  number.insert(0, digits - std::min(digits, number.size()), '0');
  return number;
}

bool leavesItsFolder(char c) { return c == '/' || static_cast<unsigned char>(c) < ' ' || c == '\x7F'; }

std::string withinItsFolder(std::string text) {
  std::replace_if(text.begin(), text.end(), leavesItsFolder, '-');
  if (text.find_first_not_of('.') == std::string::npos)
    text.assign(std::max<std::size_t>(text.size(), 1), '-');
  return text;
}

Problem noPlace(std::string_view inBraces) {
  return {words("“{place}” in the name of a file is no place to be filled: write one as {example}, with at "
                "least so "
                "many digits as {digits}.",
                {{"place", "{" + shortened(inBraces) + "}"}, {"example", "{step}"}, {"digits", "{step:02}"}}),
          "", 0, ""};
}

} // namespace

Result<OutputName::Part> OutputName::placeOf(std::string_view inBraces) {
  const auto colon = inBraces.find(':');
  Part part{"", std::string(inBraces.substr(0, colon)), 0};
  if (part.place.empty())
    return noPlace(inBraces);
  if (colon == std::string_view::npos)
    return part;
  const std::string_view digits = inBraces.substr(colon + 1);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), part.digits);
  if (error != std::errc{} || end != digits.data() + digits.size() || part.digits > mostDigits)
    return noPlace(inBraces);
  return part;
}

Result<OutputName> OutputName::parse(const std::string &typed, bool hasFrames) {
  const std::string name = hasFrames ? withFramePlace(typed) : typed;
  OutputName output;
  std::string_view rest = name;
  for (auto open = rest.find('{'); open != std::string_view::npos; open = rest.find('{')) {
    const auto close = rest.find('}', open);
    if (close == std::string_view::npos)
      return noPlace(rest.substr(open + 1));
    auto part = placeOf(rest.substr(open + 1, close - open - 1));
    if (!part)
      return part.problem();
    part->text = rest.substr(0, open);
    output.m_parts.push_back(std::move(*part));
    rest.remove_prefix(close + 1);
  }
  output.m_parts.push_back({std::string(rest)});
  return output;
}

bool OutputName::has(std::string_view place) const {
  return std::any_of(m_parts.begin(), m_parts.end(), [&](const Part &part) { return part.place == place; });
}

std::vector<std::string> OutputName::places() const {
  std::vector<std::string> names;
  for (const Part &part : m_parts)
    if (!part.place.empty())
      names.push_back(part.place);
  return names;
}

std::string OutputName::filled(const Filling &filling) const {
  std::string name;
  for (const Part &part : m_parts) {
    name += part.text;
    if (!part.place.empty())
      name += withinItsFolder(withLeadingZeros(filling(part.place), part.digits));
  }
  return name;
}

std::string OutputName::fixedFolder() const {
  return std::filesystem::path(m_parts.front().text + "x").parent_path().string(); // the place begins a name
}

} // namespace halfspace
