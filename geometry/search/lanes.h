// Four floats at once, for inner loops over very many boxes and triangles.
#pragma once

#include "geometry/vector.h"

#include <cstddef>

namespace halfspace {

inline constexpr std::size_t laneCount = 4;

/// The operators of numbers work in each lane; GCC and clang make the machine's instructions of them.
using Lanes [[gnu::vector_size(laneCount * sizeof(float))]] = float;

[[nodiscard]] inline Lanes inAllLanes(float value) { return Lanes{value, value, value, value}; }
[[nodiscard]] inline Lanes min(Lanes a, Lanes b) { return a < b ? a : b; }
[[nodiscard]] inline Lanes max(Lanes a, Lanes b) { return a > b ? a : b; }
[[nodiscard]] inline Lanes abs(Lanes a) { return max(a, -a); }

/// The lanes in which a ≤ b: bit i for lane i.
[[nodiscard]] inline unsigned lanesOfLessOrEqual(Lanes a, Lanes b) {
  const auto isLess = a <= b;
#ifdef __SSE__
  return static_cast<unsigned>(__builtin_ia32_movmskps(reinterpret_cast<Lanes>(isLess)));
#else
  unsigned bits = 0;
  for (std::size_t lane = 0; lane < laneCount; ++lane)
    bits |= isLess[lane] != 0 ? 1U << lane : 0;
  return bits;
#endif
}

/// Four vectors, by their coordinates.
using VectorLanes = Vec3<Lanes>;

inline void setLane(VectorLanes &vectors, std::size_t lane, const Vec3<float> &vector) {
  vectors.x[lane] = vector.x;
  vectors.y[lane] = vector.y;
  vectors.z[lane] = vector.z;
}
[[nodiscard]] inline VectorLanes inAllLanes(const Vec3<float> &v) {
  return {inAllLanes(v.x), inAllLanes(v.y), inAllLanes(v.z)};
}
[[nodiscard]] inline Lanes largestCoordinate(const VectorLanes &a) {
  return max(max(abs(a.x), abs(a.y)), abs(a.z));
}

} // namespace halfspace
