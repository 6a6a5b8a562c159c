// The box around points, along the axes.
#pragma once

#include "geometry/triangle.h"

#include <algorithm>
#include <limits>

namespace halfspace {

/// Around all that it was told to include; of nothing at first, and then `low` is above `high`.
struct BoundingBox {
  Vec3<double> low{std::numeric_limits<double>::infinity()};
  Vec3<double> high{-std::numeric_limits<double>::infinity()};

  void include(const Vec3<double> &point) {
    low = {std::min(low.x, point.x), std::min(low.y, point.y), std::min(low.z, point.z)};
    high = {std::max(high.x, point.x), std::max(high.y, point.y), std::max(high.z, point.z)};
  }
  void include(const Triangle<double> &triangle) {
    include(triangle.p0);
    include(triangle.p1);
    include(triangle.p2);
  }

  [[nodiscard]] Vec3<double> size() const { return high - low; }
  [[nodiscard]] double longestSide() const { return std::max({size().x, size().y, size().z}); }
};

} // namespace halfspace
