// Glyphs as small images, one texel for a pixel: to be drawn as often as a drag wants it.
#pragma once

#include "widgets/typeset/glyph_outlines.h"

#include <QCache>
#include <QImage>

namespace halfspace {

/// What tells one glyph's image from another.
struct GlyphLook {
  /// Sizes are kept in so many parts of a pixel.
  static constexpr int partsPerPixel = 64;

  math::FontIndex font = math::FontIndex::Math;
  math::GlyphId glyph = 0;
  int size = 0;    ///< of the em, in parts of a pixel
  int thicker = 0; ///< how much is added to the width of every stroke, likewise
  int quarter = 0; ///< how many quarters of a pixel right of a pixel's edge its origin lies
  QRgb color = 0;

  bool operator==(const GlyphLook &) const = default;
};

[[nodiscard]] uint qHash(const GlyphLook &look, uint seed = 0);

struct GlyphImage {
  QImage image;     ///< null where there is nothing to be seen
  QPoint leftTop{}; ///< from the pixel of the glyph's origin
};

/// Keeps the images that were used last, up to a bound. For one thread at a time.
class GlyphImages {
public:
  explicit GlyphImages(const GlyphOutlines &outlines) : m_outlines(outlines), m_images(mostBytes) {}

  /// Good until the next call.
  [[nodiscard]] const GlyphImage &image(const GlyphLook &look) const;

private:
  static constexpr int mostBytes = 16 << 20;

  const GlyphOutlines &m_outlines;
  mutable QCache<GlyphLook, GlyphImage> m_images;
};

} // namespace halfspace
