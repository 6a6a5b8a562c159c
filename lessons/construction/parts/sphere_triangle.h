// The right triangle of a sphere's centre, the nearest point of what meets it, and a common point: of a line
// that meets the sphere, or of a plane.
#pragma once

#include "lessons/figure/figure.h"
#include "lessons/term/term.h"

#include <optional>
#include <string>

namespace halfspace {

/// The corners and the sides of the triangle, in letters.
struct SphereTriangle {
  Term center;
  Term nearest;
  Term height; ///< from the centre to the nearest point; the letter of a mark
  Term base;   ///< from there to the common point; the letter of a mark
  Term radius;
  std::string radiusMark; ///< where there is only one common point, the radius leads there alone
};

/// Adds those sides that have a length; without a common point only the height.
void drawSphereTriangle(Figure &figure, const SphereTriangle &triangle, const std::optional<Place> &common);

} // namespace halfspace
