#include "widgets/formula/math_font.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace halfspace::math {
namespace {

/// More forms of a glyph than any font has.
constexpr unsigned mostVariants = 32;
constexpr unsigned mostParts = 16;
/// How often a part may be repeated: enough for a page, and bounded whatever the font says.
constexpr double mostRepeats = 1000;

/// HarfBuzz gives the variants of a vertical direction from the bottom to the top.
hb_direction_t hbDirection(Direction direction) {
  return direction == Direction::Vertical ? HB_DIRECTION_BTT : HB_DIRECTION_LTR;
}

bool isExtender(const hb_ot_math_glyph_part_t &part) {
  return (part.flags & HB_OT_MATH_GLYPH_PART_FLAG_EXTENDER) != 0;
}

/// The parts of an assembly, and how they can be put together. Lengths are in the font's units.
class Assembly {
public:
  Assembly(std::vector<hb_ot_math_glyph_part_t> parts, double leastOverlap)
      : m_parts(std::move(parts)), m_leastOverlap(leastOverlap), m_mostOverlap(leastOverlap) {
    double connector = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < m_parts.size(); ++i) {
      (isExtender(m_parts[i]) ? m_growing : m_fixed) += m_parts[i].full_advance;
      ++(isExtender(m_parts[i]) ? m_growingCount : m_fixedCount);
      if (i > 0)
        connector = std::min<double>({connector, static_cast<double>(m_parts[i - 1].end_connector_length),
                                      static_cast<double>(m_parts[i].start_connector_length)});
    }
    if (std::isfinite(connector))
      m_mostOverlap = std::max(leastOverlap, connector);
  }

  /// At least `length` long, where repeating can achieve it.
  [[nodiscard]] Stretched build(double length, double unitsPerEm) const {
    const double repeats = repeatsFor(length);
    const double count = m_fixedCount + repeats * m_growingCount;
    const double full = m_fixed + repeats * m_growing;
    const double overlap =
        count > 1 ? std::clamp((full - length) / (count - 1), m_leastOverlap, m_mostOverlap) : 0;
    Stretched stretched;
    double at = 0;
    for (const hb_ot_math_glyph_part_t &part : m_parts)
      for (double k = 0; k < (isExtender(part) ? repeats : 1); ++k) {
        stretched.parts.push_back({part.glyph, at / unitsPerEm});
        at += part.full_advance - overlap;
      }
    stretched.length = (at + overlap) / unitsPerEm;
    return stretched;
  }

private:
  [[nodiscard]] double repeatsFor(double length) const {
    const double perRepeat = m_growing - m_leastOverlap * m_growingCount;
    const double without = m_fixed - m_leastOverlap * (m_fixedCount - 1);
    return perRepeat > 0 ? std::clamp(std::ceil((length - without) / perRepeat), 0.0, mostRepeats) : 0;
  }

  std::vector<hb_ot_math_glyph_part_t> m_parts;
  double m_leastOverlap;
  double m_mostOverlap;
  double m_fixed = 0;
  double m_growing = 0;
  int m_fixedCount = 0;
  int m_growingCount = 0;
};

} // namespace

MathFont::MathFont(FontFace face) : m_face(std::move(face)), m_traits(m_face.glyphCount()) {
  for (std::size_t i = 0; i < constantCount; ++i)
    m_constants[i] = hb_ot_math_get_constant(m_face.font(), static_cast<hb_ot_math_constant_t>(i));
  findScriptLookups();
}

std::optional<MathFont> MathFont::from(FontFace face) {
  if (!hb_ot_math_has_data(face.face()))
    return std::nullopt;
  return MathFont(std::move(face));
}

void MathFont::findScriptLookups() {
  constexpr std::array<hb_tag_t, 2> features{HB_TAG('s', 's', 't', 'y'), HB_TAG_NONE};
  const HbSet lookups(hb_set_create());
  hb_ot_layout_collect_lookups(m_face.face(), HB_OT_TAG_GSUB, nullptr, nullptr, features.data(),
                               lookups.get());
  for (hb_codepoint_t lookup = HB_SET_VALUE_INVALID; hb_set_next(lookups.get(), &lookup);)
    m_scriptLookups.push_back(lookup);
}

const MathFont::Traits &MathFont::traits(GlyphId glyph) const {
  std::optional<Traits> &known = m_traits[glyph < m_traits.size() ? glyph : 0];
  if (!known) {
    hb_font_t *font = m_face.font();
    known = Traits{hb_ot_math_get_glyph_italics_correction(font, glyph) / m_face.unitsPerEm(),
                   hb_ot_math_get_glyph_top_accent_attachment(font, glyph) / m_face.unitsPerEm(),
                   findScriptForms(glyph)};
  }
  return *known;
}

std::array<GlyphId, 2> MathFont::findScriptForms(GlyphId glyph) const {
  for (const unsigned lookup : m_scriptLookups) {
    std::array<hb_codepoint_t, 2> found{};
    unsigned count = found.size();
    hb_ot_layout_lookup_get_glyph_alternates(m_face.face(), lookup, glyph, 0, &count, found.data());
    if (count > 0)
      return {found[0], count > 1 ? found[1] : found[0]};
  }
  return {glyph, glyph};
}

GlyphId MathFont::scriptForm(GlyphId glyph, int order) const {
  return traits(glyph).scriptForms[order > 1 ? 1 : 0];
}

double MathFont::kern(GlyphId glyph, hb_ot_math_kern_t corner, double height) const {
  const auto units = static_cast<hb_position_t>(std::lround(height * m_face.unitsPerEm()));
  return hb_ot_math_get_glyph_kerning(m_face.font(), glyph, corner, units) / m_face.unitsPerEm();
}

std::vector<hb_ot_math_glyph_variant_t> MathFont::variants(GlyphId glyph, Direction direction) const {
  std::vector<hb_ot_math_glyph_variant_t> found(mostVariants);
  unsigned count = mostVariants;
  hb_ot_math_get_glyph_variants(m_face.font(), glyph, hbDirection(direction), 0, &count, found.data());
  found.resize(count);
  return found;
}

std::optional<Stretched> MathFont::assemble(GlyphId glyph, double length, Direction direction) const {
  std::vector<hb_ot_math_glyph_part_t> parts(mostParts);
  unsigned count = mostParts;
  hb_ot_math_get_glyph_assembly(m_face.font(), glyph, hbDirection(direction), 0, &count, parts.data(),
                                nullptr);
  if (count == 0)
    return std::nullopt;
  parts.resize(count);
  const double overlap = hb_ot_math_get_min_connector_overlap(m_face.font(), hbDirection(direction));
  return Assembly(std::move(parts), overlap).build(length * m_face.unitsPerEm(), m_face.unitsPerEm());
}

Stretched MathFont::stretch(GlyphId glyph, double length, Direction direction) const {
  const GlyphMetrics &own = m_face.metrics(glyph);
  const double ownLength = direction == Direction::Vertical ? own.height + own.depth : own.advance;
  Stretched longest{{{glyph, 0}}, ownLength};
  if (ownLength >= length)
    return longest;
  for (const hb_ot_math_glyph_variant_t &variant : variants(glyph, direction)) {
    longest = {{{variant.glyph, 0}}, variant.advance / m_face.unitsPerEm()};
    if (longest.length >= length)
      return longest;
  }
  return assemble(glyph, length, direction).value_or(longest);
}

GlyphId MathFont::widestWithin(GlyphId glyph, double length) const {
  GlyphId widest = glyph;
  for (const hb_ot_math_glyph_variant_t &variant : variants(glyph, Direction::Horizontal))
    if (variant.advance / m_face.unitsPerEm() <= length)
      widest = variant.glyph;
  return widest;
}

std::optional<MathFonts> readMathFonts(const std::string &mathPath, const std::string &textPath) {
  std::optional<FontFace> face = FontFace::fromFile(mathPath);
  if (!face)
    return std::nullopt;
  std::optional<MathFont> font = MathFont::from(std::move(*face));
  if (!font)
    return std::nullopt;
  return MathFonts{std::move(*font), textPath.empty() ? std::nullopt : FontFace::fromFile(textPath)};
}

} // namespace halfspace::math
