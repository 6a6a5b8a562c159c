// An OpenType font face: characters to glyphs, metrics, words, outlines. Lengths are in em, y points up.
#pragma once

#include "widgets/formula/layout.h"

#include <hb.h>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace halfspace::math {

/// Deletes what HarfBuzz made.
template <auto destroy> struct Destroy {
  template <class T> void operator()(T *made) const { destroy(made); }
};
using HbBlob = std::unique_ptr<hb_blob_t, Destroy<hb_blob_destroy>>;
using HbFace = std::unique_ptr<hb_face_t, Destroy<hb_face_destroy>>;
using HbFont = std::unique_ptr<hb_font_t, Destroy<hb_font_destroy>>;
using HbBuffer = std::unique_ptr<hb_buffer_t, Destroy<hb_buffer_destroy>>;
using HbSet = std::unique_ptr<hb_set_t, Destroy<hb_set_destroy>>;

/// Of one glyph. The ink's box is [left, left + width] × [−depth, height].
struct GlyphMetrics {
  double advance = 0;
  double height = 0;
  double depth = 0;
  double left = 0;
  double width = 0;
};

/// One step of an outline; the last point is where it ends, those before it are control points.
struct PathStep {
  enum class Kind : std::uint8_t { Move, Line, Quad, Cubic, Close };
  struct Point {
    double x = 0;
    double y = 0;
  };
  Kind kind = Kind::Move;
  Point a;
  Point b; ///< of Quad and Cubic
  Point c; ///< of Cubic
};

/// A glyph of a shaped text, at its place on the baseline.
struct ShapedGlyph {
  GlyphId glyph = 0;
  double x = 0;
  double y = 0;
};

struct ShapedText {
  std::vector<ShapedGlyph> glyphs;
  double width = 0;
};

/// Answers are cached, so one face is for one thread at a time.
class FontFace {
public:
  /// A face from a font file's bytes, which must outlive it. None: these are no font.
  [[nodiscard]] static std::optional<FontFace> fromMemory(std::span<const std::byte> bytes);
  /// A face from a file. None: it cannot be read, or is no font.
  [[nodiscard]] static std::optional<FontFace> fromFile(const std::string &path);

  /// 0 when the face does not have the character.
  [[nodiscard]] GlyphId glyph(char32_t character) const;
  [[nodiscard]] const GlyphMetrics &metrics(GlyphId glyph) const;
  /// Words from left to right, kerned. The text is UTF-8.
  [[nodiscard]] ShapedText shape(std::string_view text) const;
  /// The outline, to be filled by the nonzero winding rule.
  [[nodiscard]] std::vector<PathStep> outline(GlyphId glyph) const;

  [[nodiscard]] hb_font_t *font() const { return m_font.get(); }
  [[nodiscard]] hb_face_t *face() const { return m_face.get(); }
  [[nodiscard]] double unitsPerEm() const { return m_unitsPerEm; }
  [[nodiscard]] std::size_t glyphCount() const { return m_metrics.size(); }

private:
  explicit FontFace(HbFace face);
  [[nodiscard]] static std::optional<FontFace> fromBlob(const HbBlob &blob);

  HbFace m_face;
  HbFont m_font;
  HbBuffer m_buffer;
  double m_unitsPerEm = 1;
  mutable std::vector<std::optional<GlyphMetrics>> m_metrics;
  mutable std::unordered_map<char32_t, GlyphId> m_glyphs;
};

} // namespace halfspace::math
