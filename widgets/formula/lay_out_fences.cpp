// Fences, and what else grows: glyphs put together from parts.
#include "widgets/formula/set.h"

#include <algorithm>

namespace halfspace::math {
namespace {

/// TeX's \nulldelimiterspace: the room that no fence takes.
constexpr double noFence = 0.12;

constexpr char32_t bar = U'|';
constexpr char32_t doubleBar = U'‖';

/// A bar or double bar of rules: fonts thicken the bars that they stretch, TeX's stay thin.
Box setBars(Sheet &sheet, char32_t character, double height, SetStyle style) {
  Box box = sheet.begin();
  const FontFace &face = sheet.font().face();
  const double em = sheet.em(style);
  const GlyphMetrics &single = face.metrics(face.glyph(bar));
  const GlyphMetrics &own = face.metrics(face.glyph(character));
  const double thickness = single.width * em;
  box.width = own.advance * em;
  box.ascent = height;
  sheet.putRule(own.left * em, height, thickness, height);
  if (character == doubleBar)
    sheet.putRule((own.left + own.width) * em - thickness, height, thickness, height);
  sheet.close(box);
  return box;
}

Box setStandingFence(Sheet &sheet, char32_t character, double height, SetStyle style) {
  const FontFace &face = sheet.font().face();
  const GlyphId glyph = face.glyph(character);
  const GlyphMetrics &own = face.metrics(glyph);
  if ((character == bar || character == doubleBar) && height > (own.height + own.depth) * sheet.em(style))
    return setBars(sheet, character, height, style);
  return setStretched(sheet, glyph, height, Direction::Vertical, style);
}

} // namespace

Box setStretched(Sheet &sheet, GlyphId glyph, double length, Direction direction, SetStyle style) {
  Box box = sheet.begin();
  const double em = sheet.em(style);
  const MathFont &font = sheet.font();
  const Stretched stretched = font.stretch(glyph, length / em, direction);
  for (const StretchPart &part : stretched.parts) {
    const GlyphMetrics &metrics = font.face().metrics(part.glyph);
    if (direction == Direction::Vertical) {
      sheet.putGlyph(FontIndex::Math, part.glyph, 0, (part.at + metrics.depth) * em, style);
      box.width = std::max(box.width, metrics.advance * em);
      box.ascent = std::max(box.ascent, (part.at + metrics.depth + metrics.height) * em);
    } else {
      sheet.putGlyph(FontIndex::Math, part.glyph, part.at * em, 0, style);
      box.ascent = std::max(box.ascent, metrics.height * em);
      box.depth = std::max(box.depth, metrics.depth * em);
    }
  }
  if (direction == Direction::Horizontal)
    box.width = stretched.length * em;
  if (stretched.parts.size() == 1) {
    box.italics = font.italicsCorrection(stretched.parts.front().glyph) * em;
    box.accentMiddle = font.accentAttachment(stretched.parts.front().glyph) * em;
  }
  sheet.close(box);
  return box;
}

Box setFence(Sheet &sheet, char32_t character, double height, SetStyle style) {
  Box box = sheet.begin();
  if (character == 0) {
    box.width = noFence * sheet.em(style);
    return box;
  }
  box = setStandingFence(sheet, character, height, style);
  const double up = sheet.axis(style) - box.ascent / 2;
  sheet.move(box, 0, up);
  box.ascent += up;
  box.depth -= up;
  box.italics = 0;
  box.accentMiddle.reset();
  return box;
}

Box set(Sheet &sheet, const Fenced &fenced, SetStyle style) {
  Box all = sheet.begin();
  double height = 0;
  const Box inside = setRow(sheet, fenced.row, style, {.fenceHeight = &height});
  const Box open = setFence(sheet, fenced.open, height, style);
  const Box close = setFence(sheet, fenced.close, height, style);
  sheet.place(all, open, 0, 0);
  sheet.place(all, inside, open.width, 0);
  sheet.place(all, close, open.width + inside.fullWidth(), 0);
  return all;
}

Box set(Sheet &sheet, const MiddleFence &middle, SetStyle style) {
  return setFence(sheet, middle.character, 0, style);
}

Box set(Sheet &sheet, const TallFence &fence, SetStyle style) {
  return setFence(sheet, fence.character, fence.height * sheet.em(style), style);
}

} // namespace halfspace::math
