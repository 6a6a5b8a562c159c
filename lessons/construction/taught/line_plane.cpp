// Where a line meets a plane, in homogeneous coordinates (note PL).
#include "geometry/case_names.h"
#include "geometry/intersect_line_plane.h"
#include "geometry/project_vector.h"
#include "lessons/construction/parts/line_moment.h"
#include "lessons/construction/parts/plucker_edges.h"
#include "lessons/construction/taught.h"
#include "lessons/object/kinds/plane.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<LineObject> g;
  Given<PlaneObject> E;
};

struct Out : Computed<In>, LineTerms, PlaneTerms {
  explicit Out(const In &objects)
      : Computed(objects), LineTerms(termsOf(objects.g)), PlaneTerms(termsOf(objects.E)) {}

  Plane<Rational> plane = planeThrough(in.E.object.point, in.E.object.normal);
  LinePlane<Rational> meet = intersectLinePlane(lineAlong(in.g.object.point, in.g.object.direction), plane);
  /// A line and a plane.
  bool areBoth = meet.which != LinePlaneCase::ZeroNormal && meet.which != LinePlaneCase::NotALine;
  bool hasPoint = meet.which == LinePlaneCase::Point;

  Term m = momentOf(in.g);
  Term d = name(besideLettersOf(in.E, letter("d")), plane.offset).standingFor(-dot(n, P0));
  Term X = ownName(letter("X"), meet.weighted); ///< the common point times its weight
  Term w = ownName(letter("w"), meet.weight);
  Term S = madeName("S", meet.point); ///< the common point
};

CaseWords tell(const Out &at) {
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
    return zeroNormalWords(at);
  case LinePlaneCase::NotALine:
    break;
  }
  return zeroLineWords(at, caseName);
}

WorkingLine weightedLine(const Out &at) {
  return asked(
      withNumbers(at.X == cross(at.n, at.m) - at.d * at.v),
      at.meet.which == LinePlaneCase::Point ? words("The common point, times its weight.")
      : at.meet.which == LinePlaneCase::Parallel
          ? words("A multiple of {v}: there is no common point, only the direction is left.", at.letters)
          : words("All zero: no point of the line is special, because each is a common one."),
      {{cross(at.m, at.n) - at.d * at.v,
        words("In {answer} the cross product goes the other way round: the normal comes first.")}});
}

ToldValue homogeneousValue(const Out &at) {
  const auto &[x, y, z] = at.meet.weighted;
  return {words("homogeneous coordinates"), std::vector<Surd>{x, y, z, at.meet.weight}};
}

std::string constantWords(const Out &at) {
  return words("The constant of {E}: its equation is {n}·P + {d} = 0.", at.letters, {{"d", plainText(at.d)}});
}

std::string weightWords(const Out &at) {
  return at.meet.weight == 0
             ? words("Zero: {v} is perpendicular to {n}, so the line comes no nearer to the plane.",
                     at.letters)
             : words("The weight. It is 0 only when the line is parallel to the plane, or lies in it.");
}

Figure draw(const Out &at) {
  Figure figure;
  if (!at.hasPoint)
    return figure;
  figure.add(pointOf(at.S, Role::Result, Subject::Measure));
  figure.reaches = {{at.in.g.id, place(at.S)}, {at.in.E.id, place(at.S)}};
  return figure;
}

/// The plane turned about its point until the line is parallel to it, or slid until the line lies in it. The
/// plane and not the line: the line may be made by others.
std::vector<SpecialCase> nearby(const Out &at) {
  if (!at.areBoth || at.meet.which == LinePlaneCase::InPlane)
    return {};
  const auto &[point, direction] = at.in.g.object;
  PlaneObject changed = at.in.E.object;
  if (at.meet.which == LinePlaneCase::Parallel) {
    changed.point += projectVector(ExactVec3(point - changed.point), changed.normal).projection;
    return {{is("case", "in-plane"), words("The line would lie in the plane."), "E", changed}};
  }
  changed.normal = projectVector(changed.normal, direction).rejection;
  if (isZero(changed.normal))
    return {};
  const auto which =
      intersectLinePlane(lineAlong(point, direction), planeThrough(changed.point, changed.normal)).which;
  return {{is("case", nameOf(which)),
           which == LinePlaneCase::Parallel ? words("The line would be parallel to the plane.")
                                            : words("The line would lie in the plane."),
           "E", changed}};
}

} // namespace

Construction line_plane() {
  return taught<Out, LineObject, PlaneObject>(
      {.id = "line-plane",
       .word = "intersect",
       .title = [] { return words("where the line meets the plane"); },
       .roles = {"g", "E"},
       .makes = {{"S", &Out::hasPoint, &Out::S}},
       .letters = {"X", "w"},
       .cases = {"point", "parallel", "in-plane", "not-a-line", "zero-normal"},
       .values = {{named::list("homogeneous", 4), &Out::areBoth, homogeneousValue},
                  {named::vector("point"), &Out::hasPoint, &Out::S}},
       .lines = {{"d", &Out::areBoth, [](const Out &at) { return withProducts(at.d == -dot(at.n, at.P0)); },
                  constantWords},
                 {"moment", &Out::areBoth,
                  [](const Out &at) {
                    return momentLine(at.m, at.A, at.v, words("The moment of {g}.", at.letters));
                  }},
                 {"weighted", &Out::areBoth, weightedLine},
                 {"weight", &Out::areBoth,
                  [](const Out &at) { return withProducts(at.w == dot(at.n, at.v)); }, weightWords},
                 {"point", &Out::hasPoint, [](const Out &at) { return withNumbers(at.S == at.X / at.w); },
                  says("Divided by the weight: the common point.")}},
       .marks = {"S"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
