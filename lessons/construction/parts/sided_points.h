// Points and the side of a plane that each lies on: f at each of them, told and drawn alike.
#pragma once

#include "geometry/point_plane.h"
#include "lessons/construction/naming.h"
#include "lessons/construction/special_case.h"
#include "lessons/construction/working.h"
#include "lessons/figure/figure.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"

#include <string>
#include <vector>

namespace halfspace {

/// A point in a role and what the plane says of it. f is the mark `side-A` of the role A.
struct SidedPoint {
  std::string role;
  Term point;
  Term f;
  PointPlane<Rational> measured;
};

[[nodiscard]] SidedPoint sidedPoint(const Naming &naming, const std::string &role,
                                    const Given<PlaneObject> &plane, const Given<PointObject> &point);

/// A, C
[[nodiscard]] std::string namesOf(const std::vector<Term> &points);

/// f(A) = n·(A − P₀)
[[nodiscard]] WorkingLine valueLine(const Naming &naming, const PlaneTerms &plane, const SidedPoint &sided);

/// A pin from the plane to the point, a whole one on the positive side and a dashed one on the other; a ring
/// around a point in the plane. `number` stands beside it, as long as numbers are shown.
void drawSide(Figure &figure, const Given<PlaneObject> &plane, const SidedPoint &sided, std::string number);

/// Adds that the point would lie in the plane, by a change of either; nothing where it does.
void addIntoPlane(const PlaneObject &plane, const SidedPoint &sided, const Conditions &when,
                  std::vector<SpecialCase> &all);

} // namespace halfspace
