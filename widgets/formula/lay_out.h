// From the tree of a formula to where its glyphs go: TeX's rules (The TeXbook, appendix G) with the constants
// of the font's MATH table.
#pragma once

#include "widgets/formula/layout.h"
#include "widgets/formula/math_font.h"
#include "widgets/formula/math_tree.h"

namespace halfspace::math {

/// Rows nested deeper than this are left out.
inline constexpr int deepestLayout = 400;
/// Further glyphs are left out: a short source can ask for many tall brackets, each put together from
/// hundreds.
inline constexpr std::size_t mostGlyphs = 200000;

/// Lays out a formula on one line. An empty row gives an empty layout; a character that no face has becomes
/// the glyph 0.
[[nodiscard]] Layout layOut(const Row &formula, const MathFonts &fonts, Style style = Style::Display);

} // namespace halfspace::math
