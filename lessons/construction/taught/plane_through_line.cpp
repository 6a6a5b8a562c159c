// The plane of a line and a point beside it: a cross product of two vectors in the plane is its normal.
#include "geometry/case_names.h"
#include "geometry/point_line.h"
#include "lessons/construction/parts/made_plane.h"
#include "lessons/construction/parts/several_planes.h"
#include "lessons/construction/taught.h"
#include "lessons/object/kinds/line.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<LineObject> g;
  Given<PointObject> Q;
};

struct Out : Computed<In>, LineTerms {
  explicit Out(const In &objects) : Computed(objects), LineTerms(termsOf(objects.g)) {}

  PointLine<Rational> measured = measurePointLine(in.Q.object.at, in.g.object.point, in.g.object.direction);
  bool hasPlane = measured.which == PointLineCase::Off;
  bool hasLine = measured.which != PointLineCase::ZeroDirection;
  ExactVec3 way = in.Q.object.at - in.g.object.point;

  Term Q = termOf(in.Q);
  Term w = drawnName(vectorLetter("w"), way);
  PlaneTerms E = madePlane(*this, "E", A, ExactVec3(cross(in.g.object.direction, way)));
  Term d = ownName(letter("d"), planeOf(planeOf(E)).offset);
  Term dist = ownName(word("dist"), measured.distance).marked(mark("distance")); ///< of Q from the line
};

CaseWords tell(const Out &at) {
  const std::string caseName(nameOf(at.measured.which));
  switch (at.measured.which) {
  case PointLineCase::Off:
    return {caseName, words("{E} is the only plane that contains the line {g} and the point {Q}: {equation}.",
                            at.letters, {{"equation", plainText(equationOf(at.E))}})};
  case PointLineCase::On:
    return {caseName,
            words("{Q} lies on the line {g}: every plane that contains the line contains {Q}, so none is "
                  "special.",
                  at.letters),
            true};
  case PointLineCase::ZeroDirection:
    break;
  }
  return zeroLineWords(at, caseName);
}

WorkingLine wayLine(const Out &at) {
  return asked(withNumbers(at.w == at.Q - at.A), words("From {A} to {Q}.", at.letters));
}

WorkingLine normalLine(const Out &at) {
  return asked(withProducts(at.E.n == cross(at.v, at.w)),
               at.hasPlane
                   ? words("{v} and w lie in the plane, so this is perpendicular to it.", at.letters)
                   : words("The zero vector: {v} and w lie along one line and span no plane.", at.letters),
               {{cross(at.w, at.v), words("{answer} is the cross product the other way round.")}});
}

WorkingLine checkLine(const Out &at) {
  return asked(withProducts(dot(at.E.n, at.Q) + at.d),
               words("0: {Q} fulfils the equation too, as every point of the line does.", at.letters));
}

WorkingLine distanceLine(const Out &at) {
  const Term area = norm(at.E.n);
  return asked(withNumbers(at.dist == area / norm(at.v)),
               words("How far {Q} is from the line: the area of the parallelogram of {v} and w by the length "
                     "of its side {v}.",
                     at.letters),
               {{area, words("{answer} is the area of the parallelogram: divide by |{v}|.", at.letters)}});
}

Figure draw(const Out &at) {
  Figure figure;
  if (isZero(at.way))
    return figure;
  const Place from = place(at.A);
  figure.add(arrowOf(at.w, from, Role::Derived, Subject::Point));
  if (!at.hasPlane)
    return figure;
  const Place q = place(at.Q);
  const Place foot = place(at.measured.foot);
  addMadePlane(figure, at, "E", at.E);
  figure.add(SegmentMark{drawn(at.dist, Role::Result, Subject::Measure), foot, q});
  figure.reaches = {{at.mark("E"), q}, {at.mark("E"), foot}, {at.in.g.id, foot}};
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  if (!at.hasPlane)
    return {};
  return {{is("case", "on"), words("{Q} would lie on the line, and no plane would be special.", at.letters),
           "Q", PointObject{at.measured.foot}}};
}

} // namespace

Construction plane_through_line() {
  return taught<Out, LineObject, PointObject>(
      {.id = "plane-through-line",
       .title = [] { return words("plane through line and point"); },
       .roles = {"g", "Q"},
       .makes = {{"E", PlaneObject::kind, &Out::hasPlane, [](const Out &at) { return planeOf(at.E); }}},
       .letters = {"w", "d", "dist"},
       .cases = {"off", "on", "zero-direction"},
       .values = {{named::list("coefficients", 4), &Out::hasPlane,
                   [](const Out &at) { return coefficientsValue(at.E); }},
                  {named::number("distance"), &Out::hasPlane, &Out::dist}},
       .lines = {{"w", &Out::hasLine, wayLine},
                 {"normal", &Out::hasLine, normalLine},
                 {"d", &Out::hasPlane,
                  [](const Out &at) {
                    return constantLine(at.d, at.E, words("So that {A} fulfils the equation.", at.letters));
                  }},
                 {"check", &Out::hasPlane, checkLine},
                 {"equation", &Out::hasPlane,
                  [](const Out &at) { return equationLine(at, "E", at.E, at.d); }},
                 {"distance", &Out::hasPlane, distanceLine}},
       .marks = {"w", "E", "E.n", "E.P0", "distance"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
