// Fractions and roots (The TeXbook, appendix G, rules 11 and 15).
#include "widgets/formula/set.h"

#include <algorithm>

namespace halfspace::math {
namespace {

/// TeX's \nulldelimiterspace, the room on both sides of a fraction.
constexpr double besideFraction = 0.12;

/// How far a numerator's baseline is raised and a denominator's lowered.
struct Shifts {
  double up = 0;
  double down = 0;
};

Shifts shiftsWithBar(const Sheet &sheet, const Box &top, const Box &bottom, double thickness,
                     SetStyle style) {
  const auto constant = [&](hb_ot_math_constant_t inDisplay, hb_ot_math_constant_t inText) {
    return sheet.constant(style.isDisplay() ? inDisplay : inText, style);
  };
  const double gapAbove = constant(HB_OT_MATH_CONSTANT_FRACTION_NUM_DISPLAY_STYLE_GAP_MIN,
                                   HB_OT_MATH_CONSTANT_FRACTION_NUMERATOR_GAP_MIN);
  const double gapBelow = constant(HB_OT_MATH_CONSTANT_FRACTION_DENOM_DISPLAY_STYLE_GAP_MIN,
                                   HB_OT_MATH_CONSTANT_FRACTION_DENOMINATOR_GAP_MIN);
  const double axis = sheet.axis(style);
  return {std::max(constant(HB_OT_MATH_CONSTANT_FRACTION_NUMERATOR_DISPLAY_STYLE_SHIFT_UP,
                            HB_OT_MATH_CONSTANT_FRACTION_NUMERATOR_SHIFT_UP),
                   axis + thickness / 2 + gapAbove + top.depth),
          std::max(constant(HB_OT_MATH_CONSTANT_FRACTION_DENOMINATOR_DISPLAY_STYLE_SHIFT_DOWN,
                            HB_OT_MATH_CONSTANT_FRACTION_DENOMINATOR_SHIFT_DOWN),
                   bottom.ascent + gapBelow + thickness / 2 - axis)};
}

Shifts shiftsWithoutBar(const Sheet &sheet, const Box &top, const Box &bottom, SetStyle style) {
  const auto constant = [&](hb_ot_math_constant_t inDisplay, hb_ot_math_constant_t inText) {
    return sheet.constant(style.isDisplay() ? inDisplay : inText, style);
  };
  Shifts shifts{
      constant(HB_OT_MATH_CONSTANT_STACK_TOP_DISPLAY_STYLE_SHIFT_UP, HB_OT_MATH_CONSTANT_STACK_TOP_SHIFT_UP),
      constant(HB_OT_MATH_CONSTANT_STACK_BOTTOM_DISPLAY_STYLE_SHIFT_DOWN,
               HB_OT_MATH_CONSTANT_STACK_BOTTOM_SHIFT_DOWN)};
  const double least =
      constant(HB_OT_MATH_CONSTANT_STACK_DISPLAY_STYLE_GAP_MIN, HB_OT_MATH_CONSTANT_STACK_GAP_MIN);
  const double missing = least - (shifts.up - top.depth - bottom.ascent + shifts.down);
  if (missing > 0) {
    shifts.up += missing / 2;
    shifts.down += missing / 2;
  }
  return shifts;
}

/// Puts the degree over the root's sign, and returns where the sign begins.
double placeDegree(Sheet &sheet, Box &all, const Row &row, const Box &sign, double signBottom,
                   SetStyle style) {
  const Box degree = setWhole(sheet, row, style.sized(Style::ScriptScript));
  const double before = std::max(0.0, sheet.constant(HB_OT_MATH_CONSTANT_RADICAL_KERN_BEFORE_DEGREE, style));
  const double raised =
      sheet.font().factor(HB_OT_MATH_CONSTANT_RADICAL_DEGREE_BOTTOM_RAISE_PERCENT) * sign.height();
  const double after = sheet.constant(HB_OT_MATH_CONSTANT_RADICAL_KERN_AFTER_DEGREE, style);
  // A wide degree stands out to the left, a narrow one over the sign's tail.
  const double x = std::max(before, -(degree.width + after));
  sheet.place(all, degree, x, signBottom + raised + degree.depth);
  return x + degree.width + after;
}

} // namespace

Box set(Sheet &sheet, const Fraction &fraction, SetStyle style) {
  Box all = sheet.begin();
  if (fraction.style)
    style = style.sized(*fraction.style);
  const Box top = setWhole(sheet, fraction.numerator, style.numerator());
  const Box bottom = setWhole(sheet, fraction.denominator, style.denominator());
  const double thickness =
      fraction.hasBar ? sheet.constant(HB_OT_MATH_CONSTANT_FRACTION_RULE_THICKNESS, style) : 0;
  const Shifts shifts = fraction.hasBar ? shiftsWithBar(sheet, top, bottom, thickness, style)
                                        : shiftsWithoutBar(sheet, top, bottom, style);
  const double side = besideFraction * sheet.em(style);
  const double width = std::max(top.width, bottom.width);
  sheet.place(all, top, side + (width - top.width) / 2, shifts.up);
  sheet.place(all, bottom, side + (width - bottom.width) / 2, -shifts.down);
  if (fraction.hasBar)
    sheet.putRule(side, sheet.axis(style) + thickness / 2, width, thickness);
  all.width = width + 2 * side;
  sheet.close(all);
  return all;
}

Box set(Sheet &sheet, const Root &root, SetStyle style) {
  constexpr char32_t rootSign = 0x221A;
  Box all = sheet.begin();
  const Box inside = setWhole(sheet, root.radicand, style.cramped());
  const double thickness = sheet.constant(HB_OT_MATH_CONSTANT_RADICAL_RULE_THICKNESS, style);
  const double leastGap =
      sheet.constant(style.isDisplay() ? HB_OT_MATH_CONSTANT_RADICAL_DISPLAY_STYLE_VERTICAL_GAP
                                       : HB_OT_MATH_CONSTANT_RADICAL_VERTICAL_GAP,
                     style);
  const double leastHeight = inside.height() + leastGap + thickness;
  const Box sign =
      setStretched(sheet, sheet.font().face().glyph(rootSign), leastHeight, Direction::Vertical, style);
  // What the sign is taller than it must be is shared by the gaps above and below.
  const double gap = leastGap + std::max(0.0, sign.height() - leastHeight) / 2;
  const double top = inside.ascent + gap + thickness;
  const double bottom = top - sign.height();
  const double x = root.degree.empty() ? 0 : placeDegree(sheet, all, root.degree, sign, bottom, style);
  sheet.place(all, sign, x, bottom);
  sheet.place(all, inside, x + sign.width, 0);
  sheet.putRule(x + sign.width, top, inside.width, thickness);
  all.ascent = std::max(all.ascent, top + sheet.constant(HB_OT_MATH_CONSTANT_RADICAL_EXTRA_ASCENDER, style));
  sheet.close(all);
  return all;
}

} // namespace halfspace::math
