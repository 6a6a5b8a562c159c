// A formula's tree as a line of text, to compare it with what is expected.
#pragma once

#include "widgets/formula/read_latex.h"

#include <string>
#include <string_view>

namespace halfspace::math {

/// A character by itself, with its class behind it unless it is Ord: `x`, `+:Bin`. Anything else by its kind,
/// with what it has in parentheses: `frac(a|b)`. Italic letters are shown as `x`, upright ones as `upright
/// x`.
[[nodiscard]] std::string described(const Row &row);

/// The description of a source, or `error COLUMN: SENTENCE`.
[[nodiscard]] std::string read(std::string_view latex, const Macros &macros = {});

} // namespace halfspace::math
