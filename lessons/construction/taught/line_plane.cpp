// Where a line meets a plane, in homogeneous coordinates (note PL).
#include "geometry/case_names.h"
#include "geometry/intersect_line_plane.h"
#include "geometry/project_vector.h"
#include "lessons/construction/construction.h"
#include "lessons/construction/parts/line_moment.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<LineObject> g;
  Given<PlaneObject> E;
};

struct Out : Naming, LineTerms, PlaneTerms {
  LinePlane<Rational> meet;
  Term m;    ///< the line's moment
  Term d;    ///< the plane's constant
  Term X, w; ///< the common point times its weight, and the weight
  Term S;    ///< the common point
};

/// d of the plane: it says whose it is where the plane's n does.
Term constantOf(const Given<PlaneObject> &plane, const PlaneTerms &terms, const Rational &value) {
  Symbol d = letter("d");
  d.owner = plane.letters.back().owner;
  return name(std::move(d), value).standingFor(-dot(terms.n, terms.P0));
}

Out compute(const In &in) {
  const auto line = lineAlong(in.g.object.point, in.g.object.direction);
  const auto plane = planeThrough(in.E.object.point, in.E.object.normal);
  const auto meet = intersectLinePlane(line, plane);
  const PlaneTerms E = termsOf(in.E);
  return {in,
          termsOf(in.g),
          E,
          meet,
          momentOf(in.g),
          constantOf(in.E, E, plane.offset),
          name(in.own(letter("X")), meet.weighted),
          name(in.own(letter("w")), meet.weight),
          madeName(in, "S", meet.point)};
}

CaseWords tell(const In &, const Out &at) {
  const std::string caseName(nameOf(at.meet.which));
  switch (at.meet.which) {
  case LinePlaneCase::Point:
    return {caseName, words("The weight {w} is not 0: the line {g} meets the plane {E} in {point}.",
                            at.letters, {{"w", equation(at.w)}, {"point", equation(at.S)}})};
  case LinePlaneCase::Parallel:
    return {caseName, words("The weight is 0 and X is not: the line {g} is parallel to the plane {E}. They "
                            "meet at infinity only.",
                            at.letters)};
  case LinePlaneCase::InPlane:
    return {caseName, words("All four numbers are 0: the line {g} lies in the plane {E}.", at.letters)};
  case LinePlaneCase::ZeroNormal:
    return {caseName,
            words("The normal {n} is the zero vector: it points nowhere, so there is no plane.", at.letters),
            true};
  case LinePlaneCase::NotALine:
    break;
  }
  return {caseName,
          words("The direction {v} is the zero vector: it points nowhere, so there is no line.", at.letters),
          true};
}

bool isDegenerate(const Out &at) {
  return at.meet.which == LinePlaneCase::ZeroNormal || at.meet.which == LinePlaneCase::NotALine;
}

std::vector<NamedValue> valuesOf(const In &, const Out &at) {
  if (isDegenerate(at))
    return {};
  const auto &[x, y, z] = at.meet.weighted;
  std::vector<NamedValue> values{
      {"homogeneous", words("homogeneous coordinates"), std::vector<Surd>{x, y, z, at.meet.weight}}};
  if (at.meet.which == LinePlaneCase::Point)
    values.push_back(listed("point", at.S));
  return values;
}

std::vector<MadeObject> make(const In &, const Out &at) {
  if (at.meet.which != LinePlaneCase::Point)
    return {};
  return {{"S", PointObject{at.meet.point}}};
}

WorkingLine constantLine(const Out &at) {
  return asked(
      withProducts(at.d == -dot(at.n, at.P0)),
      words("The constant of {E}: its equation is {n}·P + {d} = 0.", at.letters, {{"d", plainText(at.d)}}));
}

WorkingLine momentLine(const Out &at) {
  return asked(withProducts(at.m == cross(at.A, at.v)), words("The moment of {g}.", at.letters),
               {{cross(at.v, at.A),
                 words("{answer} is the cross product the other way round: begin with the point.")}});
}

WorkingLine weightedLine(const Out &at) {
  return asked(
      withNumbers(at.X == cross(at.n, at.m) - at.d * at.v),
      at.meet.which == LinePlaneCase::Point
          ? words("The common point, times a number that is still to come: the weight.")
      : at.meet.which == LinePlaneCase::Parallel
          ? words("A multiple of {v}: there is no common point, only the direction is left.", at.letters)
          : words("All zero: no point of the line is special, because each is a common one."),
      {{cross(at.m, at.n) - at.d * at.v,
        words("In {answer} the cross product goes the other way round: the normal comes first.")}});
}

WorkingLine weightLine(const Out &at) {
  return asked(
      withProducts(at.w == dot(at.n, at.v)),
      at.meet.weight == 0
          ? words("Zero: {v} is perpendicular to {n}, so the line comes no nearer to the plane.", at.letters)
          : words("The weight. It is 0 only when the line is parallel to the plane, or lies in it."));
}

WorkingLine pointLine(const Out &at) {
  return asked(withNumbers(at.S == at.X / at.w), words("Divided by the weight: the common point."));
}

Explanation explain(const In &, const Out &at) {
  Explanation lines;
  if (isDegenerate(at))
    return lines;
  lines.add("d", [&at] { return constantLine(at); });
  lines.add("moment", [&at] { return momentLine(at); });
  lines.add("weighted", [&at] { return weightedLine(at); });
  lines.add("weight", [&at] { return weightLine(at); });
  if (at.meet.which == LinePlaneCase::Point)
    lines.add("point", [&at] { return pointLine(at); });
  return lines;
}

Figure draw(const In &in, const Out &at) {
  Figure figure;
  if (at.meet.which != LinePlaneCase::Point)
    return figure;
  figure.add(pointOf(at.S, Role::Result, Subject::Measure));
  figure.reaches = {{in.g.id, place(at.S)}, {in.E.id, place(at.S)}};
  return figure;
}

/// The plane turned about its point until the line is parallel to it, or slid until the line lies in it. The
/// plane and not the line: the line may be made by others.
std::vector<SpecialCase> nearby(const In &in, const Out &at) {
  if (isDegenerate(at) || at.meet.which == LinePlaneCase::InPlane)
    return {};
  const auto &[point, direction] = in.g.object;
  PlaneObject changed = in.E.object;
  if (at.meet.which == LinePlaneCase::Parallel) {
    changed.point += projectVector(ExactVec3(point - changed.point), changed.normal).projection;
    return {{"case = in-plane", words("The line would lie in the plane."), "E", changed}};
  }
  changed.normal = projectVector(changed.normal, direction).rejection;
  if (isZero(changed.normal))
    return {};
  const auto which =
      intersectLinePlane(lineAlong(point, direction), planeThrough(changed.point, changed.normal)).which;
  return {{"case = " + std::string(nameOf(which)),
           which == LinePlaneCase::Parallel ? words("The line would be parallel to the plane.")
                                            : words("The line would lie in the plane."),
           "E", changed}};
}

} // namespace

Construction line_plane() {
  return makeConstruction<In, Out, LineObject, PlaneObject>(
      "line-plane", {"g", "E"}, {{"S", "point"}}, {"X", "w"},
      {.cases = {"point", "parallel", "in-plane", "not-a-line", "zero-normal"},
       .values = {named::list("homogeneous", 4), named::vector("point")},
       .lines = {"d", "moment", "weighted", "weight", "point"},
       .marks = {"S"}},
      {compute, tell, valuesOf, make, explain, draw, nearby});
}

} // namespace halfspace
