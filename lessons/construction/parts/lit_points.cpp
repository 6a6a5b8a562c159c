#include "lessons/construction/parts/lit_points.h"

#include "lessons/construction/parts/own_names.h"
#include "lessons/object/drawing.h"
#include "lessons/object/letters.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

/// S(A), with the place that it comes to, if any.
Term castName(const Naming &naming, const char *light, const Term &point, const Shadow<Rational> &shadow,
              const std::string &mark) {
  return applied(naming.own(letter(light)), point, shadow.place).marked(naming.mark(mark));
}

/// A piece of light; nothing where it has no length.
void addLight(Figure &figure, const MarkBase &base, const Place &from, const Place &to) {
  if (from != to)
    figure.add(SegmentMark{base, from, to});
}

/// Where the light gets to the plane, which is drawn as far.
void addPlace(Figure &figure, const Lights &lights, const Term &place, bool falls) {
  const PointMark mark = pointOf(place, falls ? Role::Result : Role::Ghost, Subject::Neutral);
  figure.reaches.push_back({lights.plane.id, mark.at});
  figure.add(mark);
}

} // namespace

LitPoint litPoint(const Naming &naming, const Lights &lights, const std::string &role, const Term &point) {
  const auto &[through, normal] = lights.plane.object;
  const Plane<Rational> plane = planeThrough(through, normal);
  const ExactVec3 at = vectorOf(point);
  const auto bySun = castBySun(at, lights.sun.object.vector, plane);
  const auto byLamp = castByLamp(at, lights.lamp.object.at, plane);
  return {role,
          point,
          bySun,
          byLamp,
          ownName(naming, letter("t", role), bySun.t),
          ownName(naming, letter("k", role), byLamp.t),
          castName(naming, "S", point, bySun, "sun-" + role),
          castName(naming, "L", point, byLamp, "lamp-" + role)};
}

void drawSunlight(Figure &figure, const Lights &lights, const LitPoint &lit) {
  if (!lit.bySun.crosses())
    return;
  const bool falls = lit.bySun.falls();
  addPlace(figure, lights, lit.S, falls);
  const Place step = place(lights.sun.object.vector);
  const Place point = place(lit.point);
  const Place onPlane = place(lit.S);
  const MarkBase light =
      inLook(lights.sun.look, MarkBase{lit.S->mark + "/light", Role::Helper, Subject::Neutral});
  addLight(figure, light, (falls ? point : onPlane) - step, falls ? onPlane : point);
}

void drawLamplight(Figure &figure, const Lights &lights, const LitPoint &lit) {
  if (!lit.byLamp.crosses())
    return;
  const bool isAway = lit.byLamp.which == ShadowCase::Away;
  addPlace(figure, lights, lit.L, lit.byLamp.falls());
  const Place lamp = place(lights.lamp.object.at);
  const Place point = place(lit.point);
  const Place onPlane = place(lit.L);
  const auto base = [&](Role role, const char *part) {
    return inLook(lights.lamp.look, MarkBase{lit.L->mark + part, role, Subject::Point});
  };
  addLight(figure, base(Role::Helper, "/light"), lamp, isAway ? point : onPlane);
  if (!lit.byLamp.falls())
    addLight(figure, base(Role::Ghost, "/rest"), isAway ? lamp : onPlane, isAway ? onPlane : point);
}

Word wordOf(ShadowCase which) {
  switch (which) {
  case ShadowCase::Falls:
    return {"falls", words("falls onto the plane")};
  case ShadowCase::PlaneFirst:
    return {"plane-first", words("none, the plane comes first")};
  case ShadowCase::Away:
    return {"away", words("none, the ray leads away")};
  case ShadowCase::Parallel:
    return {"parallel", words("none, the light runs along the plane")};
  case ShadowCase::NoLight:
  case ShadowCase::NoPlane:
    break;
  }
  return {"at-lamp", words("none, it is at the lamp")};
}

} // namespace halfspace
