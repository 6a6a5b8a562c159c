// What the points have in common that two sides of a triangle lead to: P0 + s u + t v with u = P1 − P0 and
// v = P2 − P0.
#pragma once

#include "lessons/object/bound_point.h"

namespace halfspace {

/// Their freedoms.
enum SideSteps : std::uint8_t { StepsOfU, StepsOfV };
[[nodiscard]] std::vector<CoordinateSpec> sideSteps();

[[nodiscard]] std::optional<ExactVec3> placeBySides(const Object &bound, const Object &host);
/// With the s and t that lead to the point of the triangle's plane that is nearest to a place; nothing where
/// the triangle is no more than a line or a point.
[[nodiscard]] std::optional<Object> nearestBySides(Object bound, const Object &host, const ExactVec3 &place);
[[nodiscard]] Object bySidesOnGrid(Object bound, const Object &host, const Rational &step);
void guideBySides(const Object &host, Handle &handle);

} // namespace halfspace
