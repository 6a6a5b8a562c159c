// A mesh for measuring, as a file.
#pragma once

#include "tests/mesh_files/mesh_texts.h"

#include <cmath>
#include <numbers>
#include <string>

namespace halfspace::bench {

/// A binary STL of a bumpy ball of about so many triangles.
inline std::string bumpyBall(std::size_t triangles) {
  const auto rows = static_cast<unsigned>(std::sqrt(static_cast<double>(triangles) / 4));
  const unsigned columns = 2 * rows;
  const auto corner = [&](unsigned row, unsigned column) {
    const double latitude = std::numbers::pi * (row + 0.5) / (rows + 1);
    const double longitude = 2 * std::numbers::pi * (column % columns) / columns;
    const double radius = 10 + std::sin(9 * latitude) * std::cos(7 * longitude);
    return Vec3<float>(Vec3<double>(std::sin(latitude) * std::cos(longitude),
                                    std::sin(latitude) * std::sin(longitude), std::cos(latitude)) *
                       radius);
  };
  std::string stl = binaryStlHead(2 * rows * columns);
  for (unsigned row = 0; row < rows; ++row)
    for (unsigned column = 0; column < columns; ++column) {
      const Vec3<float> b = corner(row, column + 1);
      const Vec3<float> c = corner(row + 1, column);
      addTo(stl, {corner(row, column), b, c});
      addTo(stl, {b, corner(row + 1, column + 1), c});
    }
  return stl;
}

} // namespace halfspace::bench
