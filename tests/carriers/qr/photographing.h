// Pictures that a camera would make of a printed code: turned, tilted, blurred, noisy, in uneven light.
#pragma once

#include "widgets/carriers/qr/grey_image.h"
#include "widgets/carriers/qr/qr_code.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>
#include <png.h>
#include <random>
#include <stdexcept>
#include <string>
#include <turbojpeg.h>

namespace halfspace::test {

/// How a code is photographed.
struct Shot {
  double degrees = 0;             ///< the camera is turned by so many
  double pixelsPerMillimetre = 8; ///< less where the paper is farther away; A4 in 12 megapixels has 13
  double tilt = 0;                ///< how much larger than its middle the nearer edge of the picture is seen
  double blur = 0;                ///< the standard deviation of a point's image, in pixels
  double noise = 0;               ///< the standard deviation of grey, of 255
  double shade = 0;               ///< how much less light there is in one corner than in the other, of 1
};

/// Grey of paper and of toner, of 255.
constexpr double paperGrey = 225;
constexpr double tonerGrey = 35;

/// A code on a large sheet of paper, its middle at the origin, in millimetres.
inline double printedGrey(const QrCode &code, glm::dvec2 place) {
  const glm::dvec2 module = place / moduleMillimetres + code.side / 2.0;
  const int column = static_cast<int>(std::floor(module.x));
  const int row = static_cast<int>(std::floor(module.y));
  const bool isInside = column >= 0 && row >= 0 && column < code.side && row < code.side;
  return isInside && code.isDark(column, row) ? tonerGrey : paperGrey;
}

/// A square picture, wider than the code by half.
class Camera {
public:
  Camera(const QrCode &code, const Shot &shot) : m_code(code), m_shot(shot) {
    const double width = 1.5 * millimetresOf(code) * shot.pixelsPerMillimetre;
    m_side = static_cast<int>(width * (1 + shot.tilt));
    const double angle = shot.degrees * glm::pi<double>() / 180;
    m_rotation = {std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle)};
  }

  [[nodiscard]] GreyImage photograph(std::uint32_t seed) const {
    std::vector<double> grey = exposed();
    blur(grey, 1, m_side);
    blur(grey, m_side, 1);
    return developed(grey, seed);
  }

private:
  [[nodiscard]] std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_side) + static_cast<std::size_t>(x);
  }

  /// The place on the paper that is seen at a place of the picture.
  [[nodiscard]] glm::dvec2 seen(glm::dvec2 pixel) const {
    const double half = m_side / 2.0;
    const glm::dvec2 fromMiddle = pixel - half;
    const glm::dvec2 turned = fromMiddle / (1 + m_shot.tilt * fromMiddle.y / half);
    return m_rotation * turned / m_shot.pixelsPerMillimetre;
  }

  [[nodiscard]] std::vector<double> exposed() const {
    constexpr int samples = 3; // in each direction of a pixel
    std::vector<double> grey(at(0, m_side));
    for (int y = 0; y < m_side; ++y)
      for (int x = 0; x < m_side; ++x) {
        double sum = 0;
        for (int i = 0; i < samples * samples; ++i)
          sum += printedGrey(m_code,
                             seen({x + (i % samples + 0.5) / samples, y + (i / samples + 0.5) / samples}));
        grey[at(x, y)] = sum / (samples * samples);
      }
    return grey;
  }

  /// Along one direction, in which pixels are so many numbers apart.
  void blur(std::vector<double> &grey, int step, int other) const {
    if (m_shot.blur <= 0)
      return;
    const int reach = static_cast<int>(std::ceil(3 * m_shot.blur));
    std::vector<double> line(static_cast<std::size_t>(m_side));
    for (int start = 0; start < m_side; ++start) {
      const auto number = [&](int i) { return static_cast<std::size_t>(start * other + i * step); };
      for (int i = 0; i < m_side; ++i) {
        double sum = 0;
        double weights = 0;
        for (int j = std::max(0, i - reach); j <= std::min(m_side - 1, i + reach); ++j) {
          const double weight = std::exp(-0.5 * (i - j) * (i - j) / (m_shot.blur * m_shot.blur));
          sum += weight * grey[number(j)];
          weights += weight;
        }
        line[static_cast<std::size_t>(i)] = sum / weights;
      }
      for (int i = 0; i < m_side; ++i)
        grey[number(i)] = line[static_cast<std::size_t>(i)];
    }
  }

  [[nodiscard]] GreyImage developed(const std::vector<double> &grey, std::uint32_t seed) const {
    std::mt19937 dice(seed);
    GreyImage image{m_side, m_side, {}};
    for (int y = 0; y < m_side; ++y)
      for (int x = 0; x < m_side; ++x) {
        const double light = 1 - m_shot.shade * (x + y) / (2.0 * m_side);
        // Four dice make nearly a bell: of one die from 0 to 1 the variance is 1/12.
        double bell = -2;
        for (int i = 0; i < 4; ++i)
          bell += static_cast<double>(dice()) / static_cast<double>(std::mt19937::max());
        const double value = light * grey[at(x, y)] + m_shot.noise * std::sqrt(3.0) * bell;
        image.pixels.push_back(static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0)));
      }
    return image;
  }

  const QrCode &m_code;
  Shot m_shot;
  glm::dmat2 m_rotation{1};
  int m_side = 0;
};

/// A code as a program draws it, in whole pixels, at the top left corner of a white picture that is so wide;
/// as wide as the code with its quiet zone where no width is named.
inline GreyImage drawn(const QrCode &code, int width = 0) {
  constexpr int pixels = 3; // a module
  const int side = pixels * (code.side + 2 * quietModules);
  GreyImage image{std::max(side, width), side, {}};
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < image.width; ++x) {
      const int column = x / pixels - quietModules;
      const int row = y / pixels - quietModules;
      const bool isInside = column >= 0 && row >= 0 && column < code.side && row < code.side;
      image.pixels.push_back(isInside && code.isDark(column, row) ? 0 : 255);
    }
  return image;
}

inline std::string pngOf(const GreyImage &image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_GRAY;
  png_alloc_size_t size = 0;
  if (png_image_write_to_memory(&png, nullptr, &size, 0, image.pixels.data(), 0, nullptr) == 0)
    throw std::runtime_error(png.message);
  std::string file(size, '\0');
  if (png_image_write_to_memory(&png, file.data(), &size, 0, image.pixels.data(), 0, nullptr) == 0)
    throw std::runtime_error(png.message);
  file.resize(size);
  return file;
}

inline std::string jpegOf(const GreyImage &image, int quality = 80, int flags = 0) {
  const tjhandle encoder = tjInitCompress();
  unsigned char *bytes = nullptr;
  unsigned long size = 0;
  const int result = tjCompress2(encoder, image.pixels.data(), image.width, 0, image.height, TJPF_GRAY,
                                 &bytes, &size, TJSAMP_GRAY, quality, flags);
  std::string file(reinterpret_cast<const char *>(bytes), size);
  tjFree(bytes);
  tjDestroy(encoder);
  if (result != 0)
    throw std::runtime_error("no JPEG");
  return file;
}

} // namespace halfspace::test
