// Accents, bars, braces and arrows: what grows over and under a base.
#include "widgets/formula/set.h"

#include <algorithm>

namespace halfspace::math {
namespace {

/// Between a base and its brace, in em.
constexpr double braceGap = 0.1;
/// An arrow stands out on both sides of what is written on it, and is never shorter than this, in em.
constexpr double arrowPadding = 0.4;
constexpr double shortestArrow = 1.4;

/// Combining arrows are put together from parts; a hat or tilde has only so many sizes.
bool isArrow(char32_t character) { return character >= 0x20D0; }

/// The accent's glyph, stretched where it is to be.
Box setMark(Sheet &sheet, const Accent &accent, double baseWidth, SetStyle style) {
  const MathFont &font = sheet.font();
  const double em = sheet.em(style);
  GlyphId glyph = font.face().glyph(accent.character);
  if (style.isScript())
    glyph = font.scriptForm(glyph, style.size == Style::ScriptScript ? 2 : 1);
  if (accent.isWide && isArrow(accent.character))
    return setStretched(sheet, glyph, baseWidth, Direction::Horizontal, style);
  if (accent.isWide)
    glyph = font.widestWithin(glyph, baseWidth / em);
  return setStretched(sheet, glyph, 0, Direction::Horizontal, style);
}

} // namespace

Box set(Sheet &sheet, const Accent &accent, SetStyle style) {
  Box all = setRow(sheet, accent.base, style.cramped());
  const double baseWidth = all.fullWidth();
  const Box mark = setMark(sheet, accent, baseWidth, style);
  const double middle = all.character && all.accentMiddle ? *all.accentMiddle : baseWidth / 2;
  const double markMiddle = mark.accentMiddle.value_or(mark.width / 2);
  const double up =
      all.ascent - std::min(all.ascent, sheet.constant(HB_OT_MATH_CONSTANT_ACCENT_BASE_HEIGHT, style));
  sheet.move(mark, middle - markMiddle, up);
  all.ascent = std::max(all.ascent, mark.ascent + up);
  sheet.close(all);
  return all;
}

Box set(Sheet &sheet, const Bar &bar, SetStyle style) {
  const bool isAbove = bar.side == Side::Above;
  Box all = setWhole(sheet, bar.base, isAbove ? style.cramped() : style);
  all.character.reset();
  all.accentMiddle.reset();
  if (isAbove) {
    const double thickness = sheet.constant(HB_OT_MATH_CONSTANT_OVERBAR_RULE_THICKNESS, style);
    all.ascent += sheet.constant(HB_OT_MATH_CONSTANT_OVERBAR_VERTICAL_GAP, style) + thickness;
    sheet.putRule(0, all.ascent, all.width, thickness);
    all.ascent += sheet.constant(HB_OT_MATH_CONSTANT_OVERBAR_EXTRA_ASCENDER, style);
  } else {
    const double thickness = sheet.constant(HB_OT_MATH_CONSTANT_UNDERBAR_RULE_THICKNESS, style);
    // Under what has no descenders the bar stays below the baseline.
    all.depth = std::max(all.depth, 0.0) + sheet.constant(HB_OT_MATH_CONSTANT_UNDERBAR_VERTICAL_GAP, style) +
                thickness;
    sheet.putRule(0, thickness - all.depth, all.width, thickness);
    all.depth += sheet.constant(HB_OT_MATH_CONSTANT_UNDERBAR_EXTRA_DESCENDER, style);
  }
  sheet.close(all);
  return all;
}

Box set(Sheet &sheet, const Brace &brace, SetStyle style) {
  Box all = sheet.begin();
  const Box inside = setWhole(sheet, brace.base, style);
  const GlyphId glyph = sheet.font().face().glyph(brace.character);
  Box mark = setStretched(sheet, glyph, inside.width, Direction::Horizontal, style);
  mark.italics = 0;
  const double gap = braceGap * sheet.em(style);
  const double width = std::max(inside.width, mark.width);
  sheet.place(all, inside, (width - inside.width) / 2, 0);
  const double up =
      brace.side == Side::Above ? inside.ascent + gap + mark.depth : -(inside.depth + gap + mark.ascent);
  sheet.place(all, mark, (width - mark.width) / 2, up);
  return all;
}

Box set(Sheet &sheet, const LongArrow &arrow, SetStyle style) {
  Box all = sheet.begin();
  const Box above = setWhole(sheet, arrow.above, style.superscript());
  const Box below = setWhole(sheet, arrow.below, style.subscript());
  const double em = sheet.em(style);
  const double length =
      std::max(std::max(above.width, below.width) + 2 * arrowPadding * em, shortestArrow * em);
  Box mark =
      setStretched(sheet, sheet.font().face().glyph(arrow.character), length, Direction::Horizontal, style);
  mark.italics = 0;
  sheet.place(all, mark, 0, 0);
  const double gap = sheet.constant(HB_OT_MATH_CONSTANT_STRETCH_STACK_GAP_ABOVE_MIN, style);
  sheet.place(all, above, (mark.width - above.width) / 2,
              std::max(mark.ascent, sheet.axis(style)) + gap + above.depth);
  if (!arrow.below.empty())
    sheet.place(all, below, (mark.width - below.width) / 2, -(mark.depth + gap + below.ascent));
  all.width = mark.width;
  return all;
}

} // namespace halfspace::math
