// How far two planes are from each other: nothing where they meet, and everywhere the same where they are
// parallel.
#include "geometry/intersect_planes.h"
#include "geometry/point_plane.h"
#include "lessons/construction/parts/two_planes.h"
#include "lessons/construction/taught.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<PlaneObject> E;
  Given<PlaneObject> F;
};

struct Out : Computed<In> {
  explicit Out(const In &objects) : Computed(objects) {}

  const PlaneObject &first = in.E.object;
  const PlaneObject &second = in.F.object;
  PlanePlane<Rational> meet =
      intersectPlanes(planeThrough(first.point, first.normal), planeThrough(second.point, second.normal));
  bool hasPlanes = meet.which != PlanePlaneCase::ZeroNormal;
  bool areParallel = meet.which == PlanePlaneCase::Parallel;
  bool areAlong = areParallel || meet.which == PlanePlaneCase::Coincident;

  PlaneTerms E = termsOf(in.E);
  PlaneTerms F = termsOf(in.F);
  Term c = ownName(vectorLetter("c"), cross(first.normal, second.normal));
  Term w = drawnName(vectorLetter("w"), ExactVec3(second.point - first.point));
  Term dist = ownName(word("dist"), meet.distance).marked(mark("dist"));
};

CaseWords tell(const Out &at) {
  switch (at.meet.which) {
  case PlanePlaneCase::Line:
    return {"meet", words("{E} and {F} are not parallel: they meet, and their distance is 0.", at.letters)};
  case PlanePlaneCase::Parallel:
    return {"parallel",
            words("{E} and {F} are parallel, and everywhere equally far from each other: "
                  "{distance}.",
                  at.letters, {{"distance", equation(name(word(words("distance")), at.dist->value))}})};
  case PlanePlaneCase::Coincident:
    return {"coincident", words("{E} and {F} are the same plane: their distance is 0.", at.letters)};
  case PlanePlaneCase::ZeroNormal:
    break;
  }
  return zeroNormalsWords(at.E, at.F);
}

std::string crossWords(const Out &at) {
  return at.areAlong ? words("The zero vector: the normals lie along one line, so the planes are parallel or "
                             "the same.")
                     : words("Not the zero vector: the normals do not lie along one line, so the planes "
                             "meet.");
}

std::string reachWords(const Out &at) {
  return at.areParallel ? words("Not 0: {F.P0} does not lie in {E}, so the planes do not meet.", at.letters)
                        : words("0: {F.P0} lies in {E}, so the planes are the same.", at.letters);
}

WorkingLine distanceLine(const Out &at) {
  const Term reach = norm(dot(at.E.n, at.w));
  return asked(
      withNumbers(at.dist == reach / norm(at.E.n)),
      at.areParallel
          ? words("How far w reaches along {E.n}, without a sign: the distance of the planes.", at.letters)
          : words("0: the planes are the same.", at.letters),
      {{reach / dot(at.E.n, at.E.n),
        words("{answer} is divided by {E.n}·{E.n}: divide by its root, |{E.n}|.", at.letters)},
       {reach, words("{answer} is |{E.n}·w|: divide it by |{E.n}|.", at.letters)},
       {norm(at.w), words("{answer} is the length of w, not how far it reaches along {E.n}.", at.letters)},
       {dot(at.E.n, at.w) / norm(at.E.n), words("{answer} has a sign: a distance is never negative.")}});
}

LineTable<Out> lines() {
  return {
      {"cross", &Out::hasPlanes, [](const Out &at) { return withProducts(at.c == cross(at.E.n, at.F.n)); },
       crossWords},
      {"w", &Out::areAlong, [](const Out &at) { return withNumbers(at.w == at.F.P0 - at.E.P0); },
       says("From {E.P0} to {F.P0}.")},
      {"reach", &Out::areAlong, [](const Out &at) { return withProducts(dot(at.E.n, at.w)); }, reachWords},
      {"distance", &Out::areAlong, distanceLine}};
}

Figure draw(const Out &at) {
  Figure figure;
  if (!at.areAlong)
    return figure;
  const Place from = place(at.E.P0);
  const Place to = place(at.F.P0);
  if (!isZero(vectorOf(at.w)))
    figure.add(arrowOf(at.w, from, Role::Derived, Subject::Point));
  const Place foot =
      place(measurePointPlane(at.second.point, planeThrough(at.first.point, at.first.normal)).foot);
  figure.reaches = {{at.in.E.id, foot}, {at.in.F.id, to}};
  if (!at.areParallel)
    return figure;
  figure.add(SegmentMark{drawn(at.dist, Role::Result, Subject::Measure), foot, to});
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  if (at.areParallel)
    return {{is("case", "coincident"), words("{E} and {F} would be the same plane.", at.letters), "E",
             slidInto(at.first, at.second)}};
  if (at.meet.which != PlanePlaneCase::Line)
    return {};
  const auto turned = turnedParallel(at.first, at.second);
  if (!turned)
    return {};
  return {{is("case", turned->isTheOther ? "coincident" : "parallel"),
           turned->isTheOther ? words("{E} and {F} would be the same plane.", at.letters)
                              : words("The planes would be parallel."),
           "E", turned->plane}};
}

} // namespace

Construction plane_distance() {
  return taught<Out, PlaneObject, PlaneObject>(
      {.id = "plane-distance",
       .word = "distance",
       .title = [] { return words("distance of the planes"); },
       .roles = {"E", "F"},
       .letters = {"c", "w", "dist"},
       .cases = {"meet", "parallel", "coincident", "zero-normal"},
       .values = {{named::number("distance"), &Out::hasPlanes, &Out::dist}},
       .lines = lines(),
       .marks = {"w", "dist"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
