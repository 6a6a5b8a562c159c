#include "lessons/reading/yaml_text.h"

#include "lessons/text.h"

#include <algorithm>
#include <array>

namespace halfspace {
namespace {

/// Means itself wherever it stands among others of these.
bool isPlain(char c) {
  constexpr std::string_view signs = "._/+-^*()!? ";
  return isLetter(c) || (c >= '0' && c <= '9') || signs.find(c) != std::string_view::npos;
}

/// Words that YAML has for nothing.
bool isNothing(std::string_view text) {
  constexpr std::array<std::string_view, 3> nothing{"null", "Null", "NULL"};
  return std::find(nothing.begin(), nothing.end(), text) != nothing.end();
}

/// Whether a text can stand without quotes.
bool needsNoQuotes(std::string_view text) {
  constexpr std::string_view beginnings = ".+-0123456789";
  return !text.empty() &&
         (isLetter(text.front()) || (beginnings.find(text.front()) != std::string_view::npos &&
                                     text.find(' ') == std::string_view::npos &&
                                     text.find_first_of("0123456789") != std::string_view::npos)) &&
         text.back() != ' ' && std::all_of(text.begin(), text.end(), isPlain) && !isNothing(text);
}

} // namespace

std::string yamlText(std::string_view text) {
  return needsNoQuotes(text) ? std::string(text) : "'" + replacedAll(std::string(text), "'", "''") + "'";
}

std::string yamlLines(std::string_view text) {
  if (text.find('\n') == std::string_view::npos)
    return yamlText(text);
  std::string lines = "|-";
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines += end == begin ? "\n" : "\n  " + std::string(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

} // namespace halfspace
