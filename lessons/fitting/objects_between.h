// Objects whose coordinates are others: a triangle by its corners.
#pragma once

#include "lessons/scene/seen_objects.h"

#include <array>

namespace halfspace {

/// The objects of which two or more are all the coordinates, each by one of them: points for positions,
/// vectors for directions, numbers for lengths and numbers. Two points are the start of a line, a ray or a
/// vector and where it leads, and three points tell a plane. Points in two places go there in their order.
[[nodiscard]] std::vector<DerivedObject> objectsBetween(const std::vector<SeenObject> &objects);

/// The plane through three points, by their names in formulas.
[[nodiscard]] DerivedObject planeThrough(const std::array<std::string, 3> &points);

} // namespace halfspace
