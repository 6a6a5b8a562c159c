#include "lessons/pseudo_language.h"

#include <algorithm>

namespace halfspace {
namespace {

constexpr std::size_t lengthens = 3; ///< by one part in so many
/// Lines break between words, so what makes a text longer is words too.
constexpr std::size_t longestPadding = 7;

std::string padding(std::size_t length) {
  std::string words;
  while (length > 0) {
    const std::size_t word = std::min(length, longestPadding);
    words += " " + std::string(word, '~');
    length -= word;
  }
  return words;
}

} // namespace

std::string inPseudoLanguage(std::string_view english) {
  return "⟦" + std::string(english) + padding((english.size() + lengthens - 1) / lengthens) + "⟧";
}

Language pseudoLanguage() {
  return {[](const char *english) { return inPseudoLanguage(english); }, ','};
}

} // namespace halfspace
