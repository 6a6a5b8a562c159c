// A language that nobody speaks, for those who work on this program: what stands in it was taken from a
// catalogue, what does not was forgotten, and what is cut off has no room for longer languages than English.
#pragma once

#include "lessons/language.h"

#include <string>
#include <string_view>

namespace halfspace {

/// The English text in ⟦brackets⟧ and about a third longer, its places to fill as they were.
[[nodiscard]] std::string inPseudoLanguage(std::string_view english);

/// With a decimal comma.
[[nodiscard]] Language pseudoLanguage();

} // namespace halfspace
