// What of a text nobody translated, and decimals that a language with a comma does not know, found in texts
// that are written in the pseudo-language.
#pragma once

#include <algorithm>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace halfspace::test {

/// In every language the same, as their owners have called them. A number at the end does not count.
using Names = std::set<std::string, std::less<>>;

namespace detail {

inline bool isWordByte(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80U ||
         c == '\'';
}

/// What formulas have everywhere.
inline const Names functions{"cos", "sin", "det", "dist", "floor",
                             "max", "min", "out", "tin",  "tout"}; // these with their indices

inline bool isNameIn(const Names &names, std::string_view word) {
  return std::any_of(names.begin(), names.end(), [word](std::string_view name) {
    return name.substr(0, name.find_last_not_of("0123456789") + 1) == word;
  });
}

/// Words of two letters are letters of formulas more often than not, and what has no vowel abbreviates.
inline bool isPlain(std::string_view word) {
  constexpr std::size_t shortestWord = 3;
  return word.size() >= shortestWord && word.find_first_of("aeiouAEIOU") != std::string_view::npos &&
         std::none_of(word.begin(), word.end(),
                      [](char c) { return static_cast<unsigned char>(c) >= 0x80U; });
}

/// The text without what is never translated:
/// - what stands in quotes or between marks of code: it is told as it stands in a file, or was typed;
/// - files, addresses, and names with a point in them: distance.f, a.md, /usr/bin;
/// - options of the command line: --set;
/// - lists of three names and more: they can be written so in a file.
inline std::string withoutNames(const std::string &text) {
  static const std::regex named("“[^”]*”|`[^`]*`"
                                "|[^\\s“(⟦]*[A-Za-z_][./][^\\s”)⟧.~]+"
                                "|--?[a-z][-a-z]*"
                                "|\\b[-\\w.]+(, [-\\w.]+){2,}");
  return std::regex_replace(text, named, " ");
}

inline std::vector<std::string> plainWordsIn(std::string_view text, const Names &names) {
  std::vector<std::string> found;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && isWordByte(text[end]))
      ++end;
    if (const std::string_view word = text.substr(at, end - at);
        isPlain(word) && !isNameIn(names, word) && !isNameIn(functions, word))
      found.emplace_back(word);
    at = std::max(end, at + 1);
  }
  return found;
}

} // namespace detail

/// The words of a text that are in no language but English.
inline std::vector<std::string> untranslatedIn(const std::string &text, const Names &names = {}) {
  const auto found = detail::plainWordsIn(text, names);
  return found.empty() ? found : detail::plainWordsIn(detail::withoutNames(text), names); // which takes long
}

/// Whether a number of a text has a decimal point. One before three digits parts them from the thousands.
inline bool hasDecimalPoint(const std::string &text) {
  static const std::regex decimal("[0-9][.]([0-9]{1,2}|[0-9]{4,})(?![0-9])");
  return text.find('.') != std::string::npos && std::regex_search(detail::withoutNames(text), decimal);
}

} // namespace halfspace::test
