// What constructions of a point and a plane share: what the plane's equation makes of the point, its signed
// distance, and its foot.
#pragma once

#include "geometry/point_plane.h"
#include "lessons/construction/parts/own_names.h"
#include "lessons/construction/working.h"
#include "lessons/figure/figure.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"

namespace halfspace {

/// The In of such a construction.
struct PointAtPlane : Naming {
  Given<PlaneObject> E;
  Given<PointObject> Q;
};

/// What its Out begins with. It makes the foot F; f and dist are letters of its own, `distance` is a mark.
struct MeasuredPoint : Computed<PointAtPlane>, PlaneTerms {
  explicit MeasuredPoint(const PointAtPlane &objects) : Computed(objects), PlaneTerms(termsOf(objects.E)) {}

  PointPlane<Rational> measured =
      measurePointPlane(in.Q.object.at, planeThrough(in.E.object.point, in.E.object.normal));
  PointPlaneCase which = measured.which;
  bool hasPlane = which != PointPlaneCase::ZeroNormal;

  Term Q = termOf(in.Q);
  Term f = applied(own(letter("f")), Q, measured.f);
  Term dist = ownName(word("dist"), measured.signedDistance).marked(mark("distance"));
  Term F = madeName("F", measured.foot);
};

/// f(Q) = n·(Q − P₀)
[[nodiscard]] WorkingLine valueLine(const MeasuredPoint &at);
/// The next two require a plane. dist = f(Q)/|n|
[[nodiscard]] WorkingLine distanceLine(const MeasuredPoint &at);
/// F = Q − f(Q)/(n·n) n
[[nodiscard]] WorkingLine footLine(const MeasuredPoint &at);

/// The way from the foot to a point that is not in the plane, with its right angle.
void drawDistance(Figure &figure, const MeasuredPoint &at);

} // namespace halfspace
