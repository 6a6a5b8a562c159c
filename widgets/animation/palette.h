// Few colours in the place of very many.
#pragma once

#include "widgets/picture/rgba_image.h"
#include "widgets/picture/theme.h"

#include <array>
#include <cstdint>
#include <vector>

namespace halfspace {

/// A pixel of less counts as not drawn where there is no half.
inline constexpr std::uint8_t leastDrawnAlpha = 128;

/// The colours of pictures, from which those of a palette are chosen.
class ColorSamples {
public:
  /// Of each picture so many pixels, evenly, that all together are no more than it takes.
  explicit ColorSamples(int pictures);
  /// Only what is drawn counts.
  void add(const RgbaImage &picture);
  [[nodiscard]] const std::vector<std::uint8_t> &rgb() const { return m_rgb; }

private:
  std::size_t m_mostPixels; ///< of a picture
  std::vector<std::uint8_t> m_rgb;
};

/// Stands for the colours of samples.
class Palette {
public:
  /// At most so many colours, up to 256.
  Palette(const ColorSamples &samples, int mostColors);

  [[nodiscard]] const std::vector<Color> &colors() const { return m_colors; }
  /// The number of the colour that is nearest to one.
  [[nodiscard]] std::uint8_t nearest(Color color);

private:
  /// One that was asked for, and what it came to.
  struct Known {
    Color color;
    std::uint8_t nearest = 0;
    bool isThere = false;
  };

  std::vector<Color> m_colors;
  std::vector<Known> m_known; ///< by a hash of the colour: most are asked for again and again
};

} // namespace halfspace
