// Points in the light of the sun and of a lamp, with where both get to a plane: told and drawn alike.
#pragma once

#include "geometry/cast_shadow.h"
#include "lessons/construction/naming.h"
#include "lessons/construction/outcome.h"
#include "lessons/figure/figure.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/vector.h"

#include <string>

namespace halfspace {

/// A plane, the direction of the sunlight, and a lamp.
struct Lights {
  const Given<PlaneObject> &plane;
  const Given<VectorObject> &sun;
  const Given<PointObject> &lamp;
};

/// A point in both lights. S(A) is the mark `sun-A` of the role A, and L(A) the mark `lamp-A`.
struct LitPoint {
  std::string role;
  Term point;
  Shadow<Rational> bySun;
  Shadow<Rational> byLamp;
  Term t; ///< steps of the sunlight from the point to the plane
  Term k; ///< steps from the lamp to the plane, each as long as the way to the point
  Term S; ///< where the sun's light gets to the plane
  Term L; ///< where that of the lamp gets to the plane
};

/// t, k, S(A) and L(A) of a point in a role; S and L come to places only where the light crosses the plane.
[[nodiscard]] LitPoint litPoint(const Naming &naming, const Lights &lights, const std::string &role,
                                const Term &point);

/// The sunlight from one step before the point, with where it gets to the plane: nothing where it does not.
void drawSunlight(Figure &figure, const Lights &lights, const LitPoint &lit);

/// The lamp's ray as far as the plane, or as far as the point where that is all that comes of it; a ghost is
/// the rest of its line. Nothing where it does not get to the plane.
void drawLamplight(Figure &figure, const Lights &lights, const LitPoint &lit);

/// How a shadow falls, or why there is none: of a plane that has a normal.
[[nodiscard]] Word wordOf(ShadowCase which);

} // namespace halfspace
