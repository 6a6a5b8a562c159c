// What constructions share that look at several planes.
#pragma once

#include "geometry/plane.h"
#include "lessons/construction/outcome.h"
#include "lessons/construction/working.h"
#include "lessons/object/kinds/plane.h"

#include <vector>

namespace halfspace {

[[nodiscard]] Plane<Rational> planeOf(const PlaneObject &plane);

/// d of a plane, −n·P0, which says whose it is where its normal does.
[[nodiscard]] Term constantOf(const Given<PlaneObject> &plane);

/// Its worked line.
[[nodiscard]] WorkingLine givenConstantLine(const Given<PlaneObject> &plane);

/// Of the first normal that is the zero vector. Requires that there is one.
[[nodiscard]] CaseWords zeroNormalAmong(const std::vector<Term> &normals);

} // namespace halfspace
