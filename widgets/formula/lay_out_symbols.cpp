// Single symbols, words and the simplest boxes.
#include "lessons/text.h"
#include "widgets/formula/latex_tokens.h"
#include "widgets/formula/set.h"

#include <algorithm>
#include <limits>
#include <string_view>

namespace halfspace::math {
namespace {

/// The frame of \boxed.
constexpr double frameRule = 0.04;
constexpr double framePadding = 0.3;

constexpr char32_t slash = 0x338; ///< combining

/// One character of a face as a box; it knows no more than its size.
Box setGlyph(Sheet &sheet, FontIndex font, GlyphId glyph, SetStyle style) {
  Box box = sheet.begin();
  const GlyphMetrics &metrics = sheet.fonts().face(font).metrics(glyph);
  const double em = sheet.em(style);
  sheet.putGlyph(font, glyph, 0, 0, style);
  box.width = metrics.advance * em;
  box.ascent = metrics.height * em;
  box.depth = metrics.depth * em;
  sheet.close(box);
  return box;
}

/// Whether a face has a character.
bool has(const std::optional<FontFace> &face, char32_t character) {
  return face && face->glyph(character) != 0;
}

/// The character, or the plain letter where the fonts lack that of an alphabet (script has often no small
/// ones).
char32_t inFonts(const MathFonts &fonts, char32_t character) {
  if (fonts.math.face().glyph(character) != 0 || has(fonts.text, character))
    return character;
  const char32_t plain = withoutAlphabet(character);
  return plain != 0 ? plain : character;
}

Box setCharacter(Sheet &sheet, char32_t asked, SetStyle style) {
  const MathFont &font = sheet.font();
  const char32_t character = inFonts(sheet.fonts(), asked);
  GlyphId glyph = font.face().glyph(character);
  if (glyph == 0 && has(sheet.fonts().text, character))
    return setGlyph(sheet, FontIndex::Text, sheet.fonts().text->glyph(character), style);
  if (style.isScript())
    glyph = font.scriptForm(glyph, style.size == Style::ScriptScript ? 2 : 1);
  Box box = setGlyph(sheet, FontIndex::Math, glyph, style);
  box.italics = font.italicsCorrection(glyph) * sheet.em(style);
  box.accentMiddle = font.accentAttachment(glyph) * sheet.em(style);
  box.character = glyph;
  return box;
}

/// Puts the middle of a box on the axis.
void centre(Sheet &sheet, Box &box, SetStyle style) {
  const double up = sheet.axis(style) - (box.ascent - box.depth) / 2;
  sheet.move(box, 0, up);
  box.ascent += up;
  box.depth -= up;
}

/// An operator's advance holds its slant already.
void takeSlantOut(Box &box) { box.width -= box.italics; }

Box setLargeOperator(Sheet &sheet, char32_t character, SetStyle style) {
  Box box;
  if (style.isDisplay()) {
    const double height = sheet.constant(HB_OT_MATH_CONSTANT_DISPLAY_OPERATOR_MIN_HEIGHT, style);
    box = setStretched(sheet, sheet.font().face().glyph(character), height, Direction::Vertical, style);
  } else {
    box = setCharacter(sheet, character, style);
    box.character.reset();
  }
  centre(sheet, box, style);
  takeSlantOut(box);
  return box;
}

/// The next character of a text ≠ "", which is taken from it.
char32_t takeCharacter(std::string_view &text) {
  const Character taken = firstCharacter(text);
  text.remove_prefix(std::max<std::size_t>(taken.length, 1));
  return taken.code;
}

/// A piece of text that one face has all characters of.
struct Run {
  FontIndex font = FontIndex::Math;
  std::string text;
};

std::vector<Run> runsOf(const MathFonts &fonts, const Words &words) {
  std::vector<Run> runs;
  for (std::string_view rest = words.text; !rest.empty();) {
    const char32_t character = inFonts(fonts, inAlphabet(takeCharacter(rest), words.alphabet));
    const bool isInMath = fonts.math.face().glyph(character) != 0;
    const FontIndex font = !isInMath && has(fonts.text, character) ? FontIndex::Text : FontIndex::Math;
    if (runs.empty() || runs.back().font != font)
      runs.push_back({font, {}});
    appendUtf8(runs.back().text, character);
  }
  return runs;
}

} // namespace

Box set(Sheet &sheet, const Symbol &symbol, SetStyle style) {
  return symbol.isLarge ? setLargeOperator(sheet, symbol.character, style)
                        : setCharacter(sheet, symbol.character, style);
}

Box set(Sheet &sheet, const Words &words, SetStyle style) {
  Box box = sheet.begin();
  const double em = sheet.em(style);
  box.ascent = box.depth = words.text.empty() ? 0 : -std::numeric_limits<double>::infinity();
  for (const Run &run : runsOf(sheet.fonts(), words)) {
    const FontFace &face = sheet.fonts().face(run.font);
    const ShapedText shaped = face.shape(run.text);
    for (const ShapedGlyph &each : shaped.glyphs) {
      const GlyphMetrics &metrics = face.metrics(each.glyph);
      sheet.putGlyph(run.font, each.glyph, box.width + each.x * em, each.y * em, style);
      box.ascent = std::max(box.ascent, (metrics.height + each.y) * em);
      box.depth = std::max(box.depth, (metrics.depth - each.y) * em);
    }
    box.width += shaped.width * em;
  }
  sheet.close(box);
  return box;
}

Box set(Sheet &sheet, const Negated &negated, SetStyle style) {
  Box box = setWhole(sheet, negated.base, style);
  const GlyphId glyph = sheet.font().face().glyph(slash);
  const GlyphMetrics &metrics = sheet.font().face().metrics(glyph);
  const double em = sheet.em(style);
  const double middle = (metrics.left + metrics.width / 2) * em;
  const double up = (box.ascent - box.depth) / 2 - (metrics.height - metrics.depth) / 2 * em;
  sheet.putGlyph(FontIndex::Math, glyph, box.width / 2 - middle, up, style);
  box.ascent = std::max(box.ascent, metrics.height * em + up);
  box.depth = std::max(box.depth, metrics.depth * em - up);
  box.character.reset();
  sheet.close(box);
  return box;
}

Box set(Sheet &sheet, const Boxed &boxed, SetStyle style) {
  Box all = sheet.begin();
  const double border = (framePadding + frameRule) * sheet.em(style);
  const double rule = frameRule * sheet.em(style);
  sheet.place(all, setWhole(sheet, boxed.row, style), border, 0);
  all.width += border;
  all.ascent += border;
  all.depth += border;
  sheet.putRule(0, all.ascent, all.width, rule);
  sheet.putRule(0, rule - all.depth, all.width, rule);
  sheet.putRule(0, all.ascent, rule, all.height());
  sheet.putRule(all.width - rule, all.ascent, rule, all.height());
  sheet.close(all);
  return all;
}

Box set(Sheet &sheet, const Phantom &phantom, SetStyle style) {
  Box box = setWhole(sheet, phantom.row, style);
  if (!phantom.isShown) {
    sheet.forget(box);
    box.end = box.begin;
  }
  if (!phantom.keepsWidth) {
    const double back = phantom.align == Align::Left ? 0 : phantom.align == Align::Right ? 1 : 0.5;
    sheet.move(box, -back * box.width, 0);
    box.width = 0;
  }
  if (!phantom.keepsHeight)
    box.ascent = box.depth = 0;
  box.character.reset();
  return box;
}

Box set(Sheet &sheet, const Block &block, SetStyle style) {
  Box box = sheet.begin();
  box.width = block.width * sheet.em(style);
  box.ascent = block.height * sheet.em(style);
  sheet.putRule(0, box.ascent, box.width, box.ascent);
  sheet.close(box);
  return box;
}

Box set(Sheet &sheet, const Room &room, SetStyle /*style*/) {
  Box box = sheet.begin();
  box.width = room.width;
  box.ascent = room.ascent;
  box.depth = room.depth;
  return box;
}

} // namespace halfspace::math
