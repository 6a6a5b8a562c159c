// What the tests of the layout share: the fonts, and formulas laid out with them.
#pragma once

#include "widgets/formula/lay_out.h"
#include "widgets/formula/read_latex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace halfspace::math {

/// Rounding of sums of lengths, in em.
inline constexpr double rounding = 1e-9;

inline const MathFonts &fonts() {
  static const std::optional<MathFonts> both = readMathFonts(MATH_FONT, TEXT_FONT);
  return both.value();
}

inline Row parsed(std::string_view latex) {
  const auto result = readLatex(latex);
  if (const auto *error = std::get_if<ReadError>(&result)) {
    ADD_FAILURE() << latex << ": " << error->column << ": " << error->sentence;
    return {};
  }
  return std::get<Row>(result);
}

inline Layout laidOut(std::string_view latex, Style style = Style::Display) {
  return layOut(parsed(latex), fonts(), style);
}

/// The ink of a glyph, y down.
inline Rectangle inkOf(const PlacedGlyph &glyph) {
  const GlyphMetrics &metrics = fonts().face(glyph.font).metrics(glyph.glyph);
  return {glyph.x + metrics.left * glyph.size, glyph.y - metrics.height * glyph.size,
          metrics.width * glyph.size, (metrics.height + metrics.depth) * glyph.size};
}

/// The glyphs of one character, also in its forms for scripts, in the order in which they were placed.
inline std::vector<PlacedGlyph> glyphsOf(const Layout &layout, char32_t character) {
  const MathFont &font = fonts().math;
  const GlyphId wanted = font.face().glyph(character);
  std::vector<PlacedGlyph> found;
  std::copy_if(layout.glyphs.begin(), layout.glyphs.end(), std::back_inserter(found),
               [&](const PlacedGlyph &each) {
                 return each.font == FontIndex::Math &&
                        (each.glyph == wanted || each.glyph == font.scriptForm(wanted, 1) ||
                         each.glyph == font.scriptForm(wanted, 2));
               });
  return found;
}

/// An italic letter of a formula, which must have just one of it.
inline PlacedGlyph letterIn(const Layout &layout, char32_t letter) {
  const auto found = glyphsOf(layout, inAlphabet(letter, Alphabet::Italic));
  EXPECT_EQ(found.size(), 1U) << "letter " << static_cast<char>(letter);
  return found.empty() ? PlacedGlyph() : found.front();
}

inline PlacedGlyph glyphIn(const Layout &layout, char32_t character) {
  const auto found = glyphsOf(layout, character);
  EXPECT_EQ(found.size(), 1U) << "character " << static_cast<unsigned>(character);
  return found.empty() ? PlacedGlyph() : found.front();
}

inline double axisHeight() { return fonts().math.constant(HB_OT_MATH_CONSTANT_AXIS_HEIGHT); }

/// The room between the advance of one glyph and the origin of another.
inline double gapBetween(const PlacedGlyph &left, const PlacedGlyph &right) {
  const FontFace &face = fonts().math.face();
  return right.x - left.x - face.metrics(left.glyph).advance * left.size;
}

} // namespace halfspace::math
