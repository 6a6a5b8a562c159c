#include "lessons/pseudo_language.h"

#include <algorithm>
#include <array>

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

struct Enclosed {
  std::string_view begin;
  std::string_view end;
};
/// What is no words of a language: a place to fill, something as it stands in a file, the kinds of files in a
/// dialog, and what formats a text.
constexpr std::array noWords{Enclosed{"{", "}"},  Enclosed{"`", "`"},  Enclosed{"(*", ")"},
                             Enclosed{"<h", ">"}, Enclosed{"<p", ">"}, Enclosed{"</", ">"}};

/// So many bytes at the beginning of a text are no words.
std::size_t lengthWithoutWords(std::string_view text) {
  for (const Enclosed &piece : noWords)
    if (text.starts_with(piece.begin))
      if (const auto end = text.find(piece.end, piece.begin.size()); end != std::string_view::npos)
        return end + piece.end.size();
  return 0;
}

struct Vowel {
  char plain;
  std::string_view accented;
};
constexpr std::array vowels{Vowel{'a', "á"}, Vowel{'e', "é"}, Vowel{'i', "í"}, Vowel{'o', "ó"},
                            Vowel{'u', "ú"}, Vowel{'A', "Á"}, Vowel{'E', "É"}, Vowel{'I', "Í"},
                            Vowel{'O', "Ó"}, Vowel{'U', "Ú"}};

} // namespace

std::string inPseudoLetters(std::string_view english) {
  std::string text;
  while (!english.empty()) {
    const std::size_t kept = std::max<std::size_t>(lengthWithoutWords(english), 1);
    const auto vowel = std::find_if(vowels.begin(), vowels.end(),
                                    [&](const Vowel &each) { return each.plain == english.front(); });
    text += vowel == vowels.end() ? english.substr(0, kept) : vowel->accented;
    english.remove_prefix(kept);
  }
  return text;
}

std::string inPseudoLanguage(std::string_view english) {
  return "⟦" + inPseudoLetters(english) + padding((english.size() + lengthens - 1) / lengthens) + "⟧";
}

Language pseudoLanguage() {
  return {[](const char *english) { return inPseudoLanguage(english); }, ','};
}

} // namespace halfspace
