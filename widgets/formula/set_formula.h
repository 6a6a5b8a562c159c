// LaTeX set in type: shapes on a page, for whoever paints or writes them.
#pragma once

#include "widgets/formula/layout.h"
#include "widgets/formula/math_font.h"
#include "widgets/formula/read_latex.h"

namespace halfspace::math {

/// A formula; or, where it cannot be had, its source in the letters of a typewriter, and why.
struct SetFormula {
  Layout layout;
  std::string error{};         ///< a sentence; empty for a formula
  std::size_t errorColumn = 0; ///< of the character of the LaTeX where it shows, counted from 1; 0: at none
};

/// Wider and higher formulas, in em, are refused: nobody could read them, and nothing could draw them.
inline constexpr double largestFormula = 400;

[[nodiscard]] SetFormula setLatex(std::string_view latex, const MathFonts &fonts, const Macros &macros = {});
/// Of a formula that did not come from LaTeX `…` is the source.
[[nodiscard]] SetFormula setFormula(const Row &formula, const MathFonts &fonts);

} // namespace halfspace::math
