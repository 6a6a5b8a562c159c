// The plane through a point that is perpendicular to a line: the line's direction is its normal.
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
  bool hasPlane = measured.which != PointLineCase::ZeroDirection;

  Term Q = termOf(in.Q);
  PlaneTerms E = madePlane(*this, "E", Q, in.g.object.direction);
  Term d = ownName(letter("d"), planeOf(planeOf(E)).offset);
  Term t = ownName(letter("t"), measured.t);
  Term S = madeName("S", measured.foot); ///< where the line meets the plane
};

CaseWords tell(const Out &at) {
  const std::string caseName(nameOf(at.measured.which));
  switch (at.measured.which) {
  case PointLineCase::Off:
    return {caseName, words("{E} goes through {Q} and is perpendicular to {g}, which it meets in {point}.",
                            at.letters, {{"point", equation(at.S)}})};
  case PointLineCase::On:
    return {caseName,
            words("{Q} lies on {g}: {E} is perpendicular to the line and meets it in {Q}.", at.letters)};
  case PointLineCase::ZeroDirection:
    break;
  }
  return zeroLineWords(at, caseName);
}

WorkingLine parameterLine(const Out &at) {
  const Term top = dot(at.E.n, at.Q - at.A);
  return asked(
      withNumbers(at.t == top / dot(at.E.n, at.v)),
      words("{A} + t {v} put into the equation and solved for t: this many steps lead from {A} to the plane.",
            at.letters),
      {{top,
        words("{answer} is {n}·({Q} − {A}): divide by {n}·{v}.", at.letters, {{"n", plainText(at.E.n)}})}});
}

Figure draw(const Out &at) {
  Figure figure;
  if (!at.hasPlane)
    return figure;
  addMadePlane(figure, at, "E", at.E);
  const Place foot = place(at.S);
  const Place q = place(at.Q);
  figure.add(pointOf(at.S, Role::Result, Subject::Measure));
  figure.reaches = {{at.in.g.id, foot}, {at.mark("E"), foot}};
  if (at.measured.which == PointLineCase::On)
    return figure;
  figure.add(SegmentMark{{at.S->mark + "/way", Role::Helper, Subject::Measure}, foot, q});
  figure.add(
      RightAngleMark{{at.S->mark + "/angle", Role::Helper, Subject::Measure}, foot, q - foot, place(at.v)});
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  if (!at.hasPlane)
    return all;
  const ExactVec3 &point = at.in.Q.object.at;
  if (at.measured.which == PointLineCase::Off)
    all.push_back({is("case", "on"), words("{Q} would lie on the line.", at.letters), "Q",
                   PointObject{at.measured.foot}});
  if (at.measured.t != 0)
    all.push_back({is("t", "0"), words("The plane would meet the line in {A}.", at.letters), "Q",
                   PointObject{ExactVec3(point - at.in.g.object.direction * at.measured.t)}});
  return all;
}

} // namespace

Construction perpendicular_plane() {
  return taught<Out, LineObject, PointObject>(
      {.id = "perpendicular-plane",
       .title = [] { return words("perpendicular plane through the point"); },
       .roles = {"g", "Q"},
       .makes = {{"E", PlaneObject::kind, &Out::hasPlane, [](const Out &at) { return planeOf(at.E); }},
                 {"S", &Out::hasPlane, &Out::S}},
       .letters = {"d", "t"},
       .cases = {"off", "on", "zero-direction"},
       .values = {{named::list("coefficients", 4), &Out::hasPlane,
                   [](const Out &at) { return coefficientsValue(at.E); }},
                  {named::number("t"), &Out::hasPlane, &Out::t},
                  {named::vector("point"), &Out::hasPlane, &Out::S}},
       .lines = {{"normal", &Out::hasPlane,
                  [](const Out &at) {
                    return line(withNumbers(at.E.n == at.v),
                                words("The direction of the line is a normal of the plane."));
                  }},
                 {"d", &Out::hasPlane,
                  [](const Out &at) {
                    return constantLine(at.d, at.E, words("So that {Q} fulfils the equation.", at.letters));
                  }},
                 {"equation", &Out::hasPlane,
                  [](const Out &at) { return equationLine(at, "E", at.E, at.d); }},
                 {"t", &Out::hasPlane, parameterLine},
                 {"point", &Out::hasPlane,
                  [](const Out &at) { return withNumbers(at.S == at.A + at.t * at.v); },
                  says("Where {g} meets {E}. It is the point of the line that is nearest to {Q}.")}},
       .marks = {"E", "E.n", "E.P0", "S"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
