// Arguments of commands that are no formulas: names, lengths, colours, brackets.
#pragma once

#include "widgets/formula/math_tree.h"
#include "widgets/formula/token_stream.h"

#include <cstddef>
#include <string>

namespace halfspace::math {

// All functions throw ReadError. `column` is where the command stands whose argument it is.

/// What stands between braces, as it was written.
[[nodiscard]] std::string readName(TokenStream &tokens, std::size_t column);

/// A length between braces, in em.
[[nodiscard]] double readLength(TokenStream &tokens, std::size_t column);
/// A length without braces: up to the two letters of its unit.
[[nodiscard]] std::string readBareLength(TokenStream &tokens);
/// `2em` or `5pt`, in em.
[[nodiscard]] double lengthOf(const std::string &text, std::size_t column);

/// `{red}` or `{#ff0000}`
[[nodiscard]] Color readColorValue(TokenStream &tokens, std::size_t column);

/// A bracket that can be stretched; 0 for the `.` that stands for none.
[[nodiscard]] char32_t readFence(TokenStream &tokens, std::size_t column);

} // namespace halfspace::math
