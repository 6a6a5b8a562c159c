// Mesh files as programs write them.
#pragma once

#include "geometry/vector.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace halfspace {

/// The bytes of a value, the lowest first, as this machine has them.
template <class Value> std::string bytesOf(const Value &value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}
/// The highest first.
template <class Value> std::string turnedBytesOf(const Value &value) {
  const std::string bytes = bytesOf(value);
  return {bytes.rbegin(), bytes.rend()};
}

using StlTriangle = std::array<Vec3<float>, 3>;

inline std::string binaryStlHead(std::uint32_t count, std::string header = "made by a test") {
  header.resize(80, '\0');
  return header + bytesOf(count);
}
inline void addTo(std::string &stl, const StlTriangle &triangle) {
  stl += std::string(sizeof(Vec3<float>), '\0');
  for (const Vec3<float> &corner : triangle)
    stl += bytesOf(corner);
  stl += std::string(2, '\0');
}
inline std::string binaryStl(const std::vector<StlTriangle> &triangles,
                             const std::string &header = "made by a test") {
  std::string stl = binaryStlHead(static_cast<std::uint32_t>(triangles.size()), header);
  for (const StlTriangle &triangle : triangles)
    addTo(stl, triangle);
  return stl;
}

inline std::string textStl(const std::vector<StlTriangle> &triangles) {
  std::string stl = "solid test\n";
  for (const StlTriangle &triangle : triangles) {
    stl += " facet normal 0 0 0\n  outer loop\n";
    for (const Vec3<float> &corner : triangle)
      stl += "   vertex " + std::to_string(corner.x) + " " + std::to_string(corner.y) + " " +
             std::to_string(corner.z) + "\n";
    stl += "  endloop\n endfacet\n";
  }
  return stl + "endsolid test\n";
}

/// A tetrahedron of side 4.
inline std::vector<StlTriangle> tetrahedronTriangles() {
  const Vec3<float> o(0, 0, 0);
  const Vec3<float> x(4, 0, 0);
  const Vec3<float> y(0, 4, 0);
  const Vec3<float> z(0, 0, 4);
  return {{o, y, x}, {o, x, z}, {o, z, y}, {x, y, z}};
}

} // namespace halfspace
