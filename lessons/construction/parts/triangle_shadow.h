// The shadow of a triangle on a plane: told and drawn.
#pragma once

#include "geometry/cast_shadow.h"
#include "lessons/construction/outcome.h"
#include "lessons/figure/figure.h"
#include "lessons/object/object.h"

#include <array>
#include <vector>

namespace halfspace {

/// A shadow of a triangle: whole, flat where the light runs along the triangle, or none where a corner throws
/// none.
struct TriangleShadow {
  std::vector<ExactVec3> corners; ///< where the light that passes those of the triangle meets the plane
  bool falls = true;
  [[nodiscard]] bool isFlat() const;
};

/// From those of the corners.
[[nodiscard]] TriangleShadow triangleShadow(const std::array<Shadow<Rational>, 3> &ofCorners);

[[nodiscard]] Word wordOf(const TriangleShadow &shadow);

/// A triangle, or what is left of it where it is none.
void drawTriangle(Figure &figure, const MarkBase &base, const std::vector<ExactVec3> &corners);

} // namespace halfspace
