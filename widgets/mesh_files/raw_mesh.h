// A mesh as a file has it, before anything about it is known to be true.
#pragma once

#include "geometry/vector.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace halfspace {

/// A file with more triangles is refused.
inline constexpr std::size_t mostMeshTriangles = 5'000'000;
/// As many as triangles that share none have.
inline constexpr std::size_t mostMeshCorners = 3 * mostMeshTriangles;

/// A number that no corner has: of a triangle whose file names one that is not there.
inline constexpr std::uint32_t noCorner = 0xFFFFFFFF;

/// Triangles by the numbers of their corners. The numbers may lead nowhere, and the coordinates be no
/// numbers.
struct RawMesh {
  std::vector<Vec3<float>> corners;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  bool operator==(const RawMesh &) const = default;
};

/// Is told from time to time how much is done, from 0 to 1; nothing where that is not known.
using PartDone = std::function<void(std::optional<double> part)>;

} // namespace halfspace
