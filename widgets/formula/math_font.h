// A font face with a MATH table, and the pair of faces that a formula is set in. Lengths are in em, y points
// up.
#pragma once

#include "widgets/formula/font_face.h"

#include <hb-ot.h>

#include <array>
#include <optional>
#include <vector>

namespace halfspace::math {

/// One glyph of a stretched character; `at` says how far along the direction of stretching it begins.
struct StretchPart {
  GlyphId glyph = 0;
  double at = 0;
};

/// A character made longer: one larger glyph, or several put together.
struct Stretched {
  std::vector<StretchPart> parts;
  double length = 0;
};

enum class Direction : std::uint8_t { Vertical, Horizontal };

/// What the MATH table says. Answers are cached, so one font is for one thread at a time.
class MathFont {
public:
  /// None: the face has no MATH table.
  [[nodiscard]] static std::optional<MathFont> from(FontFace face);

  [[nodiscard]] const FontFace &face() const { return m_face; }
  /// A length, in em.
  [[nodiscard]] double constant(hb_ot_math_constant_t which) const {
    return m_constants[static_cast<std::size_t>(which)] / m_face.unitsPerEm();
  }
  /// One of the three constants that are percentages, as a factor.
  [[nodiscard]] double factor(hb_ot_math_constant_t which) const {
    return m_constants[static_cast<std::size_t>(which)] / 100;
  }
  [[nodiscard]] double italicsCorrection(GlyphId glyph) const { return traits(glyph).italicsCorrection; }
  /// How far right of the origin the middle of an accent goes.
  [[nodiscard]] double accentAttachment(GlyphId glyph) const { return traits(glyph).accentAttachment; }
  /// How much closer (negative) to a corner of the glyph a script stands at a height.
  [[nodiscard]] double kern(GlyphId glyph, hb_ot_math_kern_t corner, double height) const;
  /// The glyph's form for scripts (order 1) and scripts of scripts (order 2), made to be scaled down.
  [[nodiscard]] GlyphId scriptForm(GlyphId glyph, int order) const;

  /// The smallest form at least `length` long, or the longest there is.
  [[nodiscard]] Stretched stretch(GlyphId glyph, double length, Direction direction) const;
  /// The longest single glyph that is at most `length` wide; the glyph itself when all are wider.
  [[nodiscard]] GlyphId widestWithin(GlyphId glyph, double length) const;

private:
  struct Traits {
    double italicsCorrection = 0;
    double accentAttachment = 0;
    std::array<GlyphId, 2> scriptForms{};
  };
  static constexpr std::size_t constantCount = HB_OT_MATH_CONSTANT_RADICAL_DEGREE_BOTTOM_RAISE_PERCENT + 1;

  explicit MathFont(FontFace face);
  void findScriptLookups();
  [[nodiscard]] const Traits &traits(GlyphId glyph) const;
  [[nodiscard]] std::array<GlyphId, 2> findScriptForms(GlyphId glyph) const;
  [[nodiscard]] std::vector<hb_ot_math_glyph_variant_t> variants(GlyphId glyph, Direction direction) const;
  [[nodiscard]] std::optional<Stretched> assemble(GlyphId glyph, double length, Direction direction) const;

  FontFace m_face;
  std::array<double, constantCount> m_constants{};
  std::vector<unsigned> m_scriptLookups; ///< of the feature ssty
  mutable std::vector<std::optional<Traits>> m_traits;
};

/// What a formula is set in.
struct MathFonts {
  MathFont math;
  std::optional<FontFace> text; ///< for characters that `math` does not have, such as Cyrillic

  [[nodiscard]] const FontFace &face(FontIndex index) const {
    return index == FontIndex::Text && text ? *text : math.face();
  }
};

/// Both faces from files; the text face may be missing (an empty path). None: the first is no font with a
/// MATH table.
[[nodiscard]] std::optional<MathFonts> readMathFonts(const std::string &mathPath,
                                                     const std::string &textPath = {});

} // namespace halfspace::math
