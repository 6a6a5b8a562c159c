// The plane of all points that are equally far from two points.
#include "lessons/construction/parts/made_plane.h"
#include "lessons/construction/parts/several_planes.h"
#include "lessons/construction/parts/two_points.h"
#include "lessons/construction/taught.h"

namespace halfspace {
namespace {

struct Out : Computed<TwoPoints> {
  explicit Out(const TwoPoints &objects) : Computed(objects) {}

  ExactVec3 way = in.B.object.at - in.A.object.at;
  bool hasPlane = !isZero(way);

  Term A = termOf(in.A);
  Term B = termOf(in.B);
  PlaneTerms E = madePlane(*this, "E", (A + B) / 2, way);
  Term d = ownName(letter("d"), planeOf(planeOf(E)).offset);
  /// Of both points from the plane.
  Term dist = ownName(word("dist"), Surd::root(dot(way, way), Rational(1, 2))).marked(mark("distance"));
};

CaseWords tell(const Out &at) {
  if (!at.hasPlane)
    return {"same-point",
            words("{A} and {B} are the same point: every point is equally far from both, and no plane is "
                  "special.",
                  at.letters),
            true};
  return {"plane",
          words("{E} has all points that are equally far from {A} and {B}: {distance} from the plane "
                "to each of the two.",
                at.letters, {{"distance", equation(name(word(words("distance")), at.dist->value))}})};
}

WorkingLine normalLine(const Out &at) {
  return asked(withNumbers(at.E.n == at.B - at.A),
               words("From {A} to {B}: the plane is perpendicular to this way.", at.letters));
}

WorkingLine middleLine(const Out &at) {
  return asked(withNumbers(at.E.P0 == (at.A + at.B) / 2),
               words("The middle between {A} and {B}, which the plane goes through.", at.letters),
               {{(at.B - at.A) / 2,
                 words("{answer} is half of the way from {A} to {B}, not where it leads.", at.letters)}});
}

WorkingLine squaresLine(const Out &at) {
  return asked(withProducts(at.d == (dot(at.A, at.A) - dot(at.B, at.B)) / 2),
               words("The same from |P − {A}|² = |P − {B}|² multiplied out, where P·P falls away on both "
                     "sides.",
                     at.letters));
}

WorkingLine distanceLine(const Out &at) {
  return asked(withProducts(at.dist == norm(at.E.n) / 2),
               words("Half of the way from {A} to {B}.", at.letters),
               {{norm(at.E.n), words("{answer} is the distance of {A} and {B}: half of it.", at.letters)}});
}

Figure draw(const Out &at) {
  Figure figure;
  if (!at.hasPlane)
    return figure;
  const Place middle = place(at.E.P0);
  addMadePlane(figure, at, "E", at.E);
  figure.add(SegmentMark{{at.dist->mark, Role::Derived, Subject::Measure}, place(at.A), middle});
  figure.add(SegmentMark{{at.dist->mark + "/other", Role::Derived, Subject::Measure}, middle, place(at.B)});
  return figure;
}

/// The second point moved until the plane goes through the origin, opposite to the first one.
std::vector<SpecialCase> nearby(const Out &at) {
  if (!at.hasPlane || sign(*numberOf(at.d)) == 0 || isZero(at.in.A.object.at))
    return {};
  return {{is("coefficients.3", "0"), words("The plane would go through the origin."), "B",
           PointObject{ExactVec3(-at.in.A.object.at)}}};
}

} // namespace

Construction perpendicular_bisector() {
  return taught<Out, PointObject, PointObject>(
      {.id = "perpendicular-bisector",
       .title = [] { return words("perpendicular bisector"); },
       .roles = {"A", "B"},
       .makes = {{"E", PlaneObject::kind, &Out::hasPlane, [](const Out &at) { return planeOf(at.E); }}},
       .letters = {"d", "dist"},
       .cases = {"plane", "same-point"},
       .values = {{named::list("coefficients", 4), &Out::hasPlane,
                   [](const Out &at) { return coefficientsValue(at.E); }},
                  {named::vector("middle"), &Out::hasPlane, [](const Out &at) { return at.E.P0; }},
                  {named::number("distance"), &Out::hasPlane, &Out::dist}},
       .lines = {{"normal", &Out::hasPlane, normalLine},
                 {"middle", &Out::hasPlane, middleLine},
                 {"d", &Out::hasPlane,
                  [](const Out &at) {
                    return constantLine(at.d, at.E, words("So that the middle fulfils the equation."));
                  }},
                 {"squares", &Out::hasPlane, squaresLine},
                 {"equation", &Out::hasPlane,
                  [](const Out &at) { return equationLine(at, "E", at.E, at.d); }},
                 {"distance", &Out::hasPlane, distanceLine}},
       .marks = {"E", "E.n", "E.P0", "distance"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
