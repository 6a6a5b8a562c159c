// Where a plane meets a sphere: the circle around the foot of the centre, by Pythagoras.
#include "geometry/case_names.h"
#include "geometry/intersect_plane_sphere.h"
#include "lessons/construction/parts/sphere_triangle.h"
#include "lessons/construction/taught.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/sphere.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace halfspace {
namespace {

struct In : Naming {
  Given<PlaneObject> E;
  Given<SphereObject> S;
};

struct Out : Computed<In>, PlaneTerms, SphereTerms {
  explicit Out(const In &objects)
      : Computed(objects), PlaneTerms(termsOf(objects.E)), SphereTerms(termsOf(objects.S)) {}

  const Rational &radius = in.S.object.radius;
  bool isSphere = radius != 0; ///< else it is a point
  Plane<Rational> plane = planeThrough(in.E.object.point, in.E.object.normal);
  PlaneSphere<Rational> meet =
      isSphere ? intersectPlaneSphere(plane, {in.S.object.center, radius}) : PlaneSphere<Rational>{};
  PointPlane<Rational> center = measurePointPlane(in.S.object.center, plane); ///< that of the sphere
  bool areBoth = isSphere && center.which != PointPlaneCase::ZeroNormal;      ///< a plane and a sphere
  bool isMet = areBoth && meet.which != PlaneSphereCase::Miss;
  bool hasCircle = isMet && meet.which != PlaneSphereCase::Tangent;

  Surd distance = center.signedDistance.sign() < 0 ? -center.signedDistance : center.signedDistance;

  Term f = applied(own(letter("f")), c, center.f);
  Term M = madeName("M", center.foot); ///< the plane's point nearest to the centre of the sphere
  Term h = drawnName(letter("h"), distance);
  Term q = ownName(letter("q"), meet.circleRadiusSquared);
  Term rho = ownName(letter("ρ"), meet.circleRadius).marked(mark("rho")); ///< the radius of the circle
};

std::string pointWords(const Out &at) {
  switch (at.center.which) {
  case PointPlaneCase::ZeroNormal:
    return words("The radius is 0: the sphere is only the point {c}.", at.letters);
  case PointPlaneCase::On:
    return words("The radius is 0: the sphere is only the point {c}, which lies in the plane {E}.",
                 at.letters);
  default:
    return words("The radius is 0: the sphere is only the point {c}, which does not lie in the plane {E}.",
                 at.letters);
  }
}

CaseWords tell(const Out &at) {
  if (!at.isSphere)
    return {"zero-radius", pointWords(at), true};
  const std::string caseName(nameOf(at.meet.which));
  const std::string h = equation(at.h);
  switch (at.meet.which) {
  case PlaneSphereCase::Circle:
    return {caseName,
            words("{h} is less than {R}: the plane {E} cuts the sphere in a circle around {M}, whose "
                  "radius is {rho}.",
                  at.letters, {{"h", h}, {"rho", equation(at.rho)}})};
  case PlaneSphereCase::GreatCircle:
    return {caseName,
            words("{h}: the plane {E} goes through the centre, and cuts the sphere in a great circle. "
                  "Its radius is {R}, as that of the sphere.",
                  at.letters, {{"h", h}})};
  case PlaneSphereCase::Tangent:
    return {caseName, words("{h} is as much as {R}: the plane {E} touches the sphere in one point, {M}.",
                            at.letters, {{"h", h}})};
  case PlaneSphereCase::Miss:
    return {caseName,
            words("{h} is more than {R}: the plane {E} misses the sphere.", at.letters, {{"h", h}})};
  case PlaneSphereCase::ZeroNormal:
    break;
  }
  return zeroNormalWords(at);
}

WorkingLine valueLine(const Out &at) {
  return asked(withNumbers(at.f == dot(at.n, at.c - at.P0)),
               at.center.which == PointPlaneCase::On
                   ? words("Zero: the centre {c} lies in the plane.", at.letters)
                   : words("Not zero: the centre {c} lies beside the plane.", at.letters),
               {{dot(at.n, at.c),
                 words("{answer} is {n}·{c}: {P0} is to be subtracted from {c} first.", at.letters)}});
}

WorkingLine distanceLine(const Out &at) {
  return asked(withNumbers(at.h == norm(at.f) / norm(at.n)), words("How far the centre is from the plane."),
               {{norm(at.f), words("{answer} is not divided by |{n}| yet.", at.letters)},
                {norm(at.f) / dot(at.n, at.n),
                 words("{answer} is divided by {n}·{n}: divide by its root, |{n}|.", at.letters)},
                {-at.h, words("{answer} is negative: a length has no sign.")}});
}

WorkingLine footLine(const Out &at) {
  return asked(withNumbers(at.M == at.c - at.f / dot(at.n, at.n) * at.n),
               at.hasCircle ? words("The foot of {c}: the centre of the circle.", at.letters)
               : at.isMet   ? words("The foot of {c}: the point where the plane touches.", at.letters)
                            : words("The foot of {c}: the plane's point nearest to the sphere.", at.letters));
}

std::string squareWords(const Out &at) {
  if (at.hasCircle)
    return words("Positive: by Pythagoras this is the square of the circle's radius.");
  return at.isMet ? words("Zero: the circle has shrunk to one point.")
                  : words("Negative: it has no real square root, so there is no circle.");
}

WorkingLine squareLine(const Out &at) {
  return asked(withNumbers(at.q == power(at.R, 2) - power(at.h, 2)), squareWords(at),
               {{power(at.R - at.h, 2),
                 words("{answer} is ({R} − h)²: square both lengths first, then subtract.", at.letters)},
                {power(at.R, 2) + power(at.h, 2),
                 words("{answer} is the sum: {R} is the longest side, so h² is subtracted.", at.letters)}});
}

WorkingLine radiusLine(const Out &at) {
  return asked(withNumbers(at.rho == root(at.q)), words("The radius of the circle."),
               {{at.q, words("{answer} is ρ²: its root is still to be taken.")},
                {at.R - at.h,
                 words("{answer} is {R} − h: the squares are subtracted, not the lengths.", at.letters)}});
}

LineTable<Out> lines() {
  return {{"f", &Out::areBoth, valueLine},
          {"h", &Out::areBoth, distanceLine},
          {"M", &Out::areBoth, footLine},
          {"square", &Out::areBoth, squareLine},
          {"rho", &Out::hasCircle, radiusLine}};
}

/// A circle is drawn as a polygon of so many corners: nearer than this no two of them are told apart.
constexpr int circleCorners = 96;

/// Two unit vectors that are perpendicular to a direction ≠ 0 and to each other.
std::pair<Place, Place> across(const ExactVec3 &direction) {
  const Place unit = unitOf(direction);
  const Place other = std::abs(unit.z) < 0.5 ? Place(0, 0, 1) : Place(1, 0, 0);
  const Place first = glm::normalize(glm::cross(other, unit));
  return {first, glm::cross(unit, first)};
}

void drawCircle(Figure &figure, const Out &at) {
  const auto [first, second] = across(at.in.E.object.normal);
  const double radius = toDouble(at.meet.circleRadius);
  PolygonMark circle{{at.mark("circle"), Role::Result, Subject::Measure}, {}};
  for (int i = 0; i < circleCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / circleCorners;
    circle.corners.push_back(place(at.M) + (first * std::cos(angle) + second * std::sin(angle)) * radius);
  }
  figure.add(std::move(circle));
}

Figure draw(const Out &at) {
  Figure figure;
  if (!at.areBoth)
    return figure;
  if (at.hasCircle)
    drawCircle(figure, at);
  figure.add(pointOf(at.M, at.isMet ? Role::Result : Role::Derived, Subject::Measure));
  std::optional<Place> common;
  if (at.isMet)
    common = place(at.M) + across(at.in.E.object.normal).first * toDouble(at.meet.circleRadius);
  drawSphereTriangle(figure, {at.c, at.M, at.h, at.rho, at.R, at.mark("radius")}, common);
  figure.reaches = {{at.in.E.id, place(at.M)}};
  return figure;
}

/// What the plane would be, moved straight until it touches the sphere on the side where it is.
void addTangent(const Out &at, std::vector<SpecialCase> &all) {
  if (at.meet.which == PlaneSphereCase::Tangent)
    return;
  SpecialCase tangent{is("case", "tangent"), words("The plane would touch the sphere."), "E", {}};
  const auto &[point, normal] = at.in.E.object;
  const Surd length = Surd::root(at.center.normalSquared);
  if (length.isRational()) {
    const Rational away = at.radius / length.rationalPart() * (at.center.f > 0 ? -1 : 1);
    const ExactVec3 touch = at.in.S.object.center + normal * away;
    tangent.object = PlaneObject{point + touch - at.center.foot, normal};
  } else {
    tangent.rootedWay = (at.distance + -at.radius).squared();
  }
  all.push_back(std::move(tangent));
}

std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  if (!at.areBoth)
    return all;
  addTangent(at, all);
  if (at.center.which != PointPlaneCase::On)
    all.push_back(
        {is("case", "great-circle"), words("The plane would go through the centre {c}.", at.letters), "E",
         PlaneObject{at.in.E.object.point + at.in.S.object.center - at.center.foot, at.in.E.object.normal}});
  return all;
}

} // namespace

Construction plane_sphere() {
  return taught<Out, PlaneObject, SphereObject>(
      {.id = "plane-sphere",
       .word = "intersect",
       .title = [] { return words("circle of intersection"); },
       .roles = {"E", "S"},
       .makes = {{"M", &Out::areBoth, &Out::M}},
       .letters = {"f", "h", "q", "ρ"},
       .cases = {"circle", "great-circle", "tangent", "miss", "zero-normal", "zero-radius"},
       .values = {{named::number("f"), &Out::areBoth, &Out::f},
                  {named::number("distance"), &Out::areBoth, &Out::h},
                  {named::vector("center"), &Out::areBoth, &Out::M},
                  {named::number("radius_squared"), &Out::areBoth, &Out::q},
                  {named::number("radius"), &Out::hasCircle, &Out::rho}},
       .lines = lines(),
       .marks = {"circle", "M", "h", "radius", "rho"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
