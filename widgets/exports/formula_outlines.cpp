#include "widgets/exports/formula_outlines.h"

#include <glm/common.hpp>

#include <algorithm>

namespace halfspace {
namespace {

/// Appends steps of a font's outline, each point of which `place` takes to the page.
template <class PlacePoint>
void append(PagePath &path, const std::vector<math::PathStep> &steps, const PlacePoint &place) {
  using Kind = math::PathStep::Kind;
  for (const math::PathStep &step : steps)
    switch (step.kind) {
    case Kind::Move:
      path.moveTo(place(step.a));
      break;
    case Kind::Line:
      path.lineTo(place(step.a));
      break;
    case Kind::Quad: { // the same curve as a cubic one
      const glm::dvec2 from = path.steps.back().to;
      const glm::dvec2 control = place(step.a);
      const glm::dvec2 to = place(step.b);
      path.curveTo(glm::mix(from, control, 2.0 / 3), glm::mix(to, control, 2.0 / 3), to);
      break;
    }
    case Kind::Cubic:
      path.curveTo(place(step.a), place(step.b), place(step.c));
      break;
    case Kind::Close:
      path.close();
      break;
    }
}

PagePath &pathFor(std::vector<InkedOutline> &outlines, Color ink) {
  const auto known = std::find_if(outlines.begin(), outlines.end(),
                                  [&](const InkedOutline &outline) { return outline.ink == ink; });
  return known != outlines.end() ? known->path : outlines.emplace_back(InkedOutline{ink, {}}).path;
}

} // namespace

glm::dvec2 originOf(const math::PlacedGlyph &glyph, const FormulaPart &part) {
  return part.start + glm::dvec2(glyph.x, glyph.y) * part.size;
}

Color colorOf(const math::Ink &ink, const FormulaPart &part) {
  return ink.color ? Color{ink.color->red, ink.color->green, ink.color->blue} : part.ink;
}

PagePath outlineOf(const math::PlacedGlyph &glyph, const FormulaPart &part, const math::MathFonts &fonts) {
  const glm::dvec2 origin = originOf(glyph, part);
  const double em = glyph.size * part.size;
  PagePath path;
  append(path, fonts.face(glyph.font).outline(glyph.glyph),
         [&](math::PathStep::Point point) { return origin + glm::dvec2(point.x, -point.y) * em; });
  return path;
}

math::Rectangle roomOf(const math::Rule &rule, const FormulaPart &part) {
  return {part.start.x + rule.box.x * part.size, part.start.y + rule.box.y * part.size,
          rule.box.width * part.size, rule.box.height * part.size};
}

PagePath rectanglePath(const math::Rectangle &room) {
  return straightPath(
      {{room.x, room.y}, {room.right(), room.y}, {room.right(), room.bottom()}, {room.x, room.bottom()}},
      true);
}

std::vector<InkedOutline> outlinesOf(const FormulaPart &part, const math::MathFonts &fonts) {
  std::vector<InkedOutline> outlines;
  for (const math::PlacedGlyph &glyph : part.formula->glyphs)
    pathFor(outlines, colorOf(glyph.ink, part)).append(outlineOf(glyph, part, fonts));
  for (const math::Rule &rule : part.formula->rules)
    pathFor(outlines, colorOf(rule.ink, part)).append(rectanglePath(roomOf(rule, part)));
  return outlines;
}

GlyphCharacters::GlyphCharacters(const math::FontFace &face) {
  const math::HbSet characters(hb_set_create());
  hb_face_collect_unicodes(face.face(), characters.get());
  hb_codepoint_t character = HB_SET_VALUE_INVALID;
  while (hb_set_next(characters.get(), &character))
    m_characters.try_emplace(face.glyph(character), character);
}

std::optional<char32_t> GlyphCharacters::characterOf(math::GlyphId glyph) const {
  const auto known = m_characters.find(glyph);
  return glyph != 0 && known != m_characters.end() ? std::optional(known->second) : std::nullopt;
}

} // namespace halfspace
