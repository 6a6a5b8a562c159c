// Formulas of a drawing as paths, and the characters of their glyphs.
#pragma once

#include "widgets/exports/drawing.h"
#include "widgets/formula/math_font.h"

#include <unordered_map>

namespace halfspace {

/// Shapes of a formula that have one colour.
struct InkedOutline {
  Color ink;
  PagePath path;
};

/// All glyphs and rules of a formula where they stand on the page, those of one colour together.
[[nodiscard]] std::vector<InkedOutline> outlinesOf(const FormulaPart &part, const math::MathFonts &fonts);

/// A glyph where it stands on the page.
[[nodiscard]] PagePath outlineOf(const math::PlacedGlyph &glyph, const FormulaPart &part,
                                 const math::MathFonts &fonts);
/// A rule where it stands on the page.
[[nodiscard]] math::Rectangle roomOf(const math::Rule &rule, const FormulaPart &part);
/// The origin of a glyph on the page.
[[nodiscard]] glm::dvec2 originOf(const math::PlacedGlyph &glyph, const FormulaPart &part);
[[nodiscard]] Color colorOf(const math::Ink &ink, const FormulaPart &part);
[[nodiscard]] PagePath rectanglePath(const math::Rectangle &room);

/// Which characters the glyphs of a face stand for; the lowest where there are several.
class GlyphCharacters {
public:
  explicit GlyphCharacters(const math::FontFace &face);
  /// Nothing for forms of glyphs that have no character of their own.
  [[nodiscard]] std::optional<char32_t> characterOf(math::GlyphId glyph) const;

private:
  std::unordered_map<math::GlyphId, char32_t> m_characters;
};

} // namespace halfspace
