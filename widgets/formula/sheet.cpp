#include "widgets/formula/sheet.h"

#include "widgets/formula/lay_out.h"

#include <algorithm>

namespace halfspace::math {

Sheet::Sheet(const MathFonts &fonts)
    : m_fonts(fonts), m_sizes{1, 1, fonts.math.factor(HB_OT_MATH_CONSTANT_SCRIPT_PERCENT_SCALE_DOWN),
                              fonts.math.factor(HB_OT_MATH_CONSTANT_SCRIPT_SCRIPT_PERCENT_SCALE_DOWN)} {}

ShapeCounts Sheet::counts() const {
  return {m_layout.glyphs.size(), m_layout.rules.size(), m_layout.tagBoxes.size()};
}

Box Sheet::begin() const {
  Box box;
  box.begin = box.end = counts();
  return box;
}

void Sheet::move(const Box &box, double right, double up) {
  if (right == 0 && up == 0)
    return;
  for (std::size_t i = box.begin.glyphs; i < box.end.glyphs; ++i) {
    m_layout.glyphs[i].x += right;
    m_layout.glyphs[i].y -= up;
  }
  const auto moveBox = [right, up](Rectangle &rectangle) {
    rectangle.x += right;
    rectangle.y -= up;
  };
  for (std::size_t i = box.begin.rules; i < box.end.rules; ++i)
    moveBox(m_layout.rules[i].box);
  for (std::size_t i = box.begin.tagBoxes; i < box.end.tagBoxes; ++i)
    moveBox(m_layout.tagBoxes[i].box);
}

void Sheet::place(Box &into, const Box &part, double right, double up) {
  move(part, right, up);
  into.width = std::max(into.width, right + part.fullWidth());
  into.ascent = std::max(into.ascent, part.ascent + up);
  into.depth = std::max(into.depth, part.depth - up);
  close(into);
}

void Sheet::forget(const Box &box) {
  m_layout.glyphs.resize(box.begin.glyphs);
  m_layout.rules.resize(box.begin.rules);
  m_layout.tagBoxes.resize(box.begin.tagBoxes);
}

void Sheet::putGlyph(FontIndex font, GlyphId glyph, double x, double up, SetStyle style) {
  if (m_layout.glyphs.size() < mostGlyphs)
    m_layout.glyphs.push_back({glyph, font, x, -up, em(style), m_ink});
}

void Sheet::putRule(double x, double top, double width, double height) {
  m_layout.rules.push_back({{x, -top, width, height}, m_ink});
}

std::size_t Sheet::openTag(const TagId &id) {
  m_layout.tags.push_back({id, m_ink.tag});
  m_ink.tag = static_cast<int>(m_layout.tags.size()) - 1;
  m_layout.tagBoxes.push_back({m_ink.tag, {}});
  return m_layout.tagBoxes.size() - 1;
}

bool Sheet::descend() {
  if (m_depth >= deepestLayout)
    return false;
  ++m_depth;
  return true;
}

} // namespace halfspace::math
