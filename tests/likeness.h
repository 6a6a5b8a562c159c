// How alike two pictures of one thing are that different programs drew. Each smooths edges in its own way,
// and tubes are thicker than pens, so pixels are not compared one by one: what one picture shows has to be
// found near the same place in the other. A mark that one of them lacks is found nowhere near.
#pragma once

#include "widgets/picture/rgba_image.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace halfspace::test {

/// What is compared of a pixel.
enum class Compared {
  Colours,
  Hues ///< how far its colour is from gray, which way: whatever the light does, and whatever is written in
       ///< black
};

/// What counts as found.
struct Nearby {
  Compared compared = Compared::Colours;
  int reach = 1;     ///< in pixels, each way
  int tolerance = 0; ///< by which a pixel may lie outside of all that is there, of 255
};

/// A patch of pixels, connected by their sides.
struct Patch {
  std::size_t area = 0; ///< in pixels
  int x = 0;            ///< of one of them
  int y = 0;
  [[nodiscard]] std::string text() const {
    return std::to_string(area) + " pixels at " + std::to_string(x) + ", " + std::to_string(y);
  }
};

/// A number for each pixel, in rows.
class NumberPlane {
public:
  NumberPlane(int width, int height)
      : m_width(width), m_height(height),
        m_numbers(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  [[nodiscard]] int &at(int x, int y) {
    return m_numbers[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) +
                     static_cast<std::size_t>(x)];
  }

  /// The first, by an order, of those within a reach of each.
  template <class Order> [[nodiscard]] NumberPlane firstNearby(int reach, Order isBefore) {
    NumberPlane across = *this;
    for (int y = 0; y < m_height; ++y)
      for (int x = 0; x < m_width; ++x)
        for (int near = std::max(0, x - reach); near <= std::min(m_width - 1, x + reach); ++near)
          across.at(x, y) = std::min(across.at(x, y), at(near, y), isBefore);
    NumberPlane both = across;
    for (int y = 0; y < m_height; ++y)
      for (int near = std::max(0, y - reach); near <= std::min(m_height - 1, y + reach); ++near)
        for (int x = 0; x < m_width; ++x)
          both.at(x, y) = std::min(both.at(x, y), across.at(x, near), isBefore);
    return both;
  }

private:
  int m_width;
  int m_height;
  std::vector<int> m_numbers;
};

/// What is compared of a picture over white.
inline std::vector<NumberPlane> planesOf(const RgbaImage &picture, Compared compared) {
  const std::size_t count = compared == Compared::Colours ? 3 : 2;
  std::vector<NumberPlane> planes(count, NumberPlane(picture.width, picture.height));
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const std::size_t pixel = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                     static_cast<std::size_t>(x));
      const int alpha = picture.rgba[pixel + 3];
      const auto channel = [&](std::size_t which) {
        return (picture.rgba[pixel + which] * alpha + 255 * (255 - alpha)) / 255;
      };
      for (std::size_t i = 0; i < count; ++i)
        planes[i].at(x, y) = compared == Compared::Colours ? channel(i) : channel(2 * i) - channel(1);
    }
  return planes;
}

/// The largest patch of those pixels for which a plane is not 0; it has none of them any more.
inline Patch takeLargestPatch(NumberPlane plane, int width, int height) {
  Patch largest;
  std::vector<std::array<int, 2>> waiting;
  const auto visit = [&](int x, int y) {
    if (x >= 0 && y >= 0 && x < width && y < height && std::exchange(plane.at(x, y), 0) != 0)
      waiting.push_back({x, y});
  };
  for (int startY = 0; startY < height; ++startY)
    for (int startX = 0; startX < width; ++startX) {
      Patch patch{0, startX, startY};
      for (visit(startX, startY); !waiting.empty(); ++patch.area) {
        const auto [x, y] = waiting.back();
        waiting.pop_back();
        visit(x - 1, y);
        visit(x + 1, y);
        visit(x, y - 1);
        visit(x, y + 1);
      }
      if (patch.area > largest.area)
        largest = patch;
    }
  return largest;
}

/// The largest patch that a picture shows and another of its size does not.
inline Patch largestStray(const RgbaImage &picture, const RgbaImage &other, const Nearby &nearby) {
  NumberPlane isStray(picture.width, picture.height);
  auto shown = planesOf(picture, nearby.compared);
  auto found = planesOf(other, nearby.compared);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    NumberPlane least = found[i].firstNearby(nearby.reach, std::less<>());
    NumberPlane most = found[i].firstNearby(nearby.reach, std::greater<>());
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x)
        if (shown[i].at(x, y) < least.at(x, y) - nearby.tolerance ||
            shown[i].at(x, y) > most.at(x, y) + nearby.tolerance)
          isStray.at(x, y) = 1;
  }
  return takeLargestPatch(std::move(isStray), picture.width, picture.height);
}

/// The largest patch that one of two pictures of one size shows and the other does not.
inline Patch largestDifference(const RgbaImage &one, const RgbaImage &other, const Nearby &nearby) {
  return std::max(largestStray(one, other, nearby), largestStray(other, one, nearby),
                  [](const Patch &a, const Patch &b) { return a.area < b.area; });
}

} // namespace halfspace::test
