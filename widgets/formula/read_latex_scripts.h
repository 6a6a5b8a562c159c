// What stands above and below an atom: `x^2`, `x_0'`, `x²`.
#pragma once

#include "widgets/formula/latex_reader.h"

namespace halfspace::math {

/// Whether a script is next.
[[nodiscard]] bool isAtScript(TokenStream &tokens);

/// The scripts that are next, for the last atom of the row, and whether they stand beside it. Throws
/// ReadError.
void readScripts(LatexReader &reader, Row &row);

} // namespace halfspace::math
