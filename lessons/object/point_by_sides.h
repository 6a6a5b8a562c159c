// What points have in common that are told by two sides of a triangle: P0 + s u + t v with u = P1 − P0,
// v = P2 − P0.
#pragma once

#include "lessons/object/bound_point.h"

namespace halfspace {

enum SideFreedom : std::uint8_t { S, T };

struct TriangleSides {
  explicit TriangleSides(const Object &triangle)
      : u(triangle[1] - triangle[0]), v(triangle[2] - triangle[0]) {}
  ExactVec3 u;
  ExactVec3 v;
};

[[nodiscard]] std::optional<ExactVec3> placeBySides(const Object &bound, const Object &triangle);

/// With the s and t of the foot of a place in the triangle's plane; nothing where there is no such plane.
[[nodiscard]] std::optional<Object> footBySides(Object bound, const Object &triangle, const ExactVec3 &place);

/// A kind of such points.
[[nodiscard]] Kind
pointBySides(std::string_view word, std::string (*noun)(), std::string_view meaning, void (*settle)(Object &),
             Object (*nearest)(Object bound, const Object &triangle, const ExactVec3 &place));

} // namespace halfspace
