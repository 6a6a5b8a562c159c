// A language that nobody speaks, for those who work on this program: what stands in it was taken from a
// catalogue, what does not was forgotten, and what is cut off has no room for longer languages than English.
// Its words are English with accents on the vowels, so that a word that was filled into a sentence without
// being translated is seen there too.
#pragma once

#include "lessons/language.h"

#include <string>
#include <string_view>

namespace halfspace {

/// English with accents: {name} and `code` stay as they are.
[[nodiscard]] std::string inPseudoLetters(std::string_view english);

/// The same in ⟦brackets⟧ and about a third longer.
[[nodiscard]] std::string inPseudoLanguage(std::string_view english);

/// With a decimal comma.
[[nodiscard]] Language pseudoLanguage();

} // namespace halfspace
