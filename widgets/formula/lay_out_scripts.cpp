// Superscripts, subscripts and limits (The TeXbook, appendix G, rules 13 and 18).
#include "widgets/formula/set.h"

#include <algorithm>

namespace halfspace::math {
namespace {

/// OpenType has one shift for subscripts; TeX has a smaller one for those without a superscript.
constexpr double loneSubscript = 0.6;

/// A base and its scripts while they find their places.
class ScriptSetter {
public:
  ScriptSetter(Sheet &sheet, const Scripts &scripts, SetStyle style)
      : m_sheet(sheet), m_style(style), m_hasAbove(!scripts.above.empty()),
        m_hasBelow(!scripts.below.empty()), m_base(setRow(sheet, scripts.base, style)) {
    if (m_hasAbove)
      m_above = setWholeCharacter(scripts.above, style.superscript());
    if (m_hasBelow)
      m_below = setWholeCharacter(scripts.below, style.subscript());
  }

  Box asLimits() {
    return setLimits(m_sheet, m_base, m_hasAbove ? &m_above : nullptr, m_hasBelow ? &m_below : nullptr,
                     m_style);
  }

  Box beside() {
    findShifts();
    if (m_hasAbove && m_hasBelow)
      keepApart();
    return place();
  }

private:
  /// A script that keeps its character, for kerning, but takes all of its room.
  Box setWholeCharacter(const Row &row, SetStyle style) {
    Box box = setRow(m_sheet, row, style);
    box.width = box.fullWidth();
    box.italics = 0;
    return box;
  }

  [[nodiscard]] double constant(hb_ot_math_constant_t which) const {
    return m_sheet.constant(which, m_style);
  }
  void findShifts();
  void keepApart();
  [[nodiscard]] Box place();
  [[nodiscard]] double kernAbove() const;
  [[nodiscard]] double kernBelow() const;
  [[nodiscard]] double kernAt(const Box &script, hb_ot_math_kern_t ofBase, double baseHeight,
                              hb_ot_math_kern_t ofScript, double scriptHeight) const;

  Sheet &m_sheet;
  SetStyle m_style;
  bool m_hasAbove;
  bool m_hasBelow;
  Box m_base;
  Box m_above;
  Box m_below;
  double m_up = 0;
  double m_down = 0;
};

void ScriptSetter::findShifts() {
  // On a single character scripts keep their usual height, on all else they stand near its corners.
  if (!m_base.character) {
    m_up = m_base.ascent -
           m_sheet.constant(HB_OT_MATH_CONSTANT_SUPERSCRIPT_BASELINE_DROP_MAX, m_style.superscript());
    m_down =
        m_base.depth + m_sheet.constant(HB_OT_MATH_CONSTANT_SUBSCRIPT_BASELINE_DROP_MIN, m_style.subscript());
  }
  const auto usualUp = m_style.isCramped ? HB_OT_MATH_CONSTANT_SUPERSCRIPT_SHIFT_UP_CRAMPED
                                         : HB_OT_MATH_CONSTANT_SUPERSCRIPT_SHIFT_UP;
  m_up = std::max(
      {m_up, constant(usualUp), m_above.depth + constant(HB_OT_MATH_CONSTANT_SUPERSCRIPT_BOTTOM_MIN)});
  const double usualDown = constant(HB_OT_MATH_CONSTANT_SUBSCRIPT_SHIFT_DOWN);
  m_down = std::max(m_down, usualDown * (m_hasAbove ? 1 : loneSubscript));
  if (!m_hasAbove)
    m_down = std::max(m_down, m_below.ascent - constant(HB_OT_MATH_CONSTANT_SUBSCRIPT_TOP_MAX));
}

void ScriptSetter::keepApart() {
  const double gap = m_up - m_above.depth - (m_below.ascent - m_down);
  const double missing = constant(HB_OT_MATH_CONSTANT_SUB_SUPERSCRIPT_GAP_MIN) - gap;
  if (missing <= 0)
    return;
  m_down += missing;
  // What the superscript's bottom still lacks to its usual height both are raised by.
  const double lift = std::min(missing, constant(HB_OT_MATH_CONSTANT_SUPERSCRIPT_BOTTOM_MAX_WITH_SUBSCRIPT) -
                                            (m_up - m_above.depth));
  if (lift > 0) {
    m_up += lift;
    m_down -= lift;
  }
}

/// The kerning of base and script at one height, which each of them counts from its own baseline.
double ScriptSetter::kernAt(const Box &script, hb_ot_math_kern_t ofBase, double baseHeight,
                            hb_ot_math_kern_t ofScript, double scriptHeight) const {
  const double large = m_sheet.em(m_style);
  const double small = m_sheet.em(m_style.superscript());
  const MathFont &font = m_sheet.font();
  const double fromScript =
      script.character ? font.kern(*script.character, ofScript, scriptHeight / small) * small : 0;
  return font.kern(*m_base.character, ofBase, baseHeight / large) * large + fromScript;
}

/// The kerning at the script's lower end and at the base's upper one: whatever keeps them apart.
double ScriptSetter::kernAbove() const {
  if (!m_base.character)
    return 0;
  const auto at = [this](double height) {
    return kernAt(m_above, HB_OT_MATH_KERN_TOP_RIGHT, height, HB_OT_MATH_KERN_BOTTOM_LEFT, height - m_up);
  };
  return std::max(at(m_up - m_above.depth), at(m_base.ascent));
}

double ScriptSetter::kernBelow() const {
  if (!m_base.character)
    return 0;
  const auto at = [this](double height) {
    return kernAt(m_below, HB_OT_MATH_KERN_BOTTOM_RIGHT, height, HB_OT_MATH_KERN_TOP_LEFT, height + m_down);
  };
  return std::max(at(m_below.ascent - m_down), at(-m_base.depth));
}

Box ScriptSetter::place() {
  Box all = m_sheet.begin();
  all.begin = m_base.begin;
  all.ascent = m_base.ascent;
  all.depth = m_base.depth;
  all.width = m_base.fullWidth();
  if (m_hasAbove)
    m_sheet.place(all, m_above, m_base.fullWidth() + kernAbove(), m_up);
  if (m_hasBelow)
    m_sheet.place(all, m_below, m_base.width + kernBelow(), -m_down);
  all.width += constant(HB_OT_MATH_CONSTANT_SPACE_AFTER_SCRIPT);
  m_sheet.close(all);
  return all;
}

} // namespace

Box set(Sheet &sheet, const Scripts &scripts, SetStyle style) {
  ScriptSetter setter(sheet, scripts, style);
  const ScriptPlace place = scriptPlaceOf(scripts.base);
  const bool hasLimits =
      place == ScriptPlace::Limits || (place == ScriptPlace::LimitsInDisplay && style.isDisplay());
  return hasLimits ? setter.asLimits() : setter.beside();
}

Box setLimits(Sheet &sheet, const Box &base, const Box *above, const Box *below, SetStyle style) {
  Box all = sheet.begin();
  all.begin = base.begin;
  const double width =
      std::max({base.fullWidth(), above ? above->fullWidth() : 0, below ? below->fullWidth() : 0});
  // The limits of a slanted operator stand at its ends.
  const double lean = base.italics / 2;
  const auto constant = [&](hb_ot_math_constant_t which) { return sheet.constant(which, style); };
  sheet.place(all, base, (width - base.fullWidth()) / 2, 0);
  if (above) {
    const double rise = std::max(constant(HB_OT_MATH_CONSTANT_UPPER_LIMIT_GAP_MIN) + above->depth,
                                 constant(HB_OT_MATH_CONSTANT_UPPER_LIMIT_BASELINE_RISE_MIN));
    sheet.place(all, *above, (width - above->fullWidth()) / 2 + lean, base.ascent + rise);
  }
  if (below) {
    const double drop = std::max(constant(HB_OT_MATH_CONSTANT_LOWER_LIMIT_GAP_MIN) + below->ascent,
                                 constant(HB_OT_MATH_CONSTANT_LOWER_LIMIT_BASELINE_DROP_MIN));
    sheet.place(all, *below, (width - below->fullWidth()) / 2 - lean, -base.depth - drop);
  }
  sheet.close(all);
  return all;
}

Box set(Sheet &sheet, const Stack &stack, SetStyle style) {
  const Box base = setWhole(sheet, stack.base, style);
  const Box above = setWhole(sheet, stack.above, style.superscript());
  const Box below = setWhole(sheet, stack.below, style.subscript());
  return setLimits(sheet, base, stack.above.empty() ? nullptr : &above,
                   stack.below.empty() ? nullptr : &below, style);
}

} // namespace halfspace::math
