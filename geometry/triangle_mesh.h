// Triangles that share their corners.
#pragma once

#include "geometry/triangle.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace halfspace {

/// Corners, and triangles of three of them by their numbers. The doubles are exactly the numbers that they
/// are.
struct TriangleMesh {
  std::vector<Vec3<double>> corners;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  /// Requires a triangle's number, and that its corners are there.
  [[nodiscard]] Triangle<double> triangle(std::size_t index) const {
    const auto &[a, b, c] = triangles[index];
    return {corners[a], corners[b], corners[c]};
  }

  bool operator==(const TriangleMesh &) const = default;
};

} // namespace halfspace
