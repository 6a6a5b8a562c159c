// The line that two planes have in common, by Plücker coordinates (note PL; its point nearest to the origin).
#include "geometry/case_names.h"
#include "geometry/intersect_planes.h"
#include "geometry/project_vector.h"
#include "lessons/construction/parts/acute_angle.h"
#include "lessons/construction/parts/several_planes.h"
#include "lessons/construction/parts/two_planes.h"
#include "lessons/construction/taught.h"
#include "lessons/object/kinds/line.h"
#include "lessons/term/angle.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<PlaneObject> E;
  Given<PlaneObject> F;
};

struct Out : Computed<In> {
  explicit Out(const In &objects) : Computed(objects) {}

  PlanePlane<Rational> meet = intersectPlanes(planeOf(in.E.object), planeOf(in.F.object));
  bool hasPlanes = meet.which != PlanePlaneCase::ZeroNormal;
  bool hasLine = meet.which == PlanePlaneCase::Line;

  PlaneTerms E = termsOf(in.E);
  PlaneTerms F = termsOf(in.F);
  Term d1 = constantOf(in.E);
  Term d2 = constantOf(in.F);
  Term v = madeName("g", "v", meet.line.direction);
  Term m = ownName(vectorLetter("m"), meet.line.moment);
  Term A = madeName("g", "A", meet.nearest); ///< the line's point nearest to the origin
  Term phi = ownName(letter("φ"), std::nullopt).marked(mark("phi")); ///< the angle between the normals
  Term cosine = applied(word("cos"), phi, meet.cosine);
};

CaseWords tell(const Out &at) {
  const std::string caseName(nameOf(at.meet.which));
  switch (at.meet.which) {
  case PlanePlaneCase::Line:
    return {caseName, words("The planes {E} and {F} meet in the line {g}.", at.letters)};
  case PlanePlaneCase::Parallel:
    return {caseName,
            words("The normals are multiples of each other, and no point lies in both planes: {E} and {F} "
                  "are parallel.",
                  at.letters)};
  case PlanePlaneCase::Coincident:
    return {caseName,
            words("{E} and {F} are the same plane: every point of one lies in the other.", at.letters)};
  case PlanePlaneCase::ZeroNormal:
    break;
  }
  return zeroNormalsWords(at.E, at.F);
}

WorkingLine directionLine(const Out &at) {
  return asked(
      withProducts(at.v == cross(at.E.n, at.F.n)),
      at.hasLine ? words("The line lies in both planes, so it is perpendicular to both normals.")
                 : words("The cross product is the zero vector: the normals lie along the same line, and the "
                         "planes share no single line."),
      {{cross(at.F.n, at.E.n),
        words("{answer} is the cross product the other way round: {F.n} × {E.n}.", at.letters)}});
}

std::string momentWords(const Out &at) {
  return words("The moment P × {v} is the same for every point P of the line. The two equations give it "
               "without knowing any point.",
               at.letters, {{"v", plainText(at.v)}});
}

std::string pointWords(const Out &at) {
  return isZero(vectorOf(at.m))
             ? words("The moment is zero: the line goes through the origin, which is its nearest point.")
             : words("The point of the line that is nearest to the origin.");
}

WorkingLine angleLine(const Out &at) {
  const std::string degrees = relatedText(degreesOf(at.cosine)); // with its relation
  return asked(withNumbers(at.cosine == dot(at.E.n, at.F.n) / (norm(at.E.n) * norm(at.F.n))),
               !at.hasLine
                   ? words("φ{degrees}°: the normals lie along the same line.", {{"degrees", degrees}})
               : sign(*numberOf(at.cosine)) >= 0
                   ? words("φ{degrees}° is the angle between the normals, and so between the planes.",
                           {{"degrees", degrees}})
                   : words("φ{degrees}° is the angle between the normals. The planes meet at 180° − φ.",
                           {{"degrees", degrees}}));
}

Figure draw(const Out &at) {
  Figure figure;
  if (!at.hasLine)
    return figure;
  const Place point = place(at.A);
  MarkBase line{at.mark("g"), Role::Result, Subject::Ray, latexOf(at.made.at("g").symbol)};
  figure.add(LineMark{std::move(line), point, unitOf(at.meet.line.direction)});
  ArrowMark direction = arrowOf(at.v, point, Role::Derived, Subject::Ray);
  direction.isFree = true;
  figure.add(std::move(direction));
  figure.add(pointOf(at.A, Role::Derived, Subject::Ray));
  addAngle(figure, {at.phi, degreesOf(at.cosine), at.meet.cosine == Surd(0), Role::Derived}, point,
           {place(at.E.n), Subject::Plane, at.in.E.look}, {place(at.F.n), Subject::Plane, at.in.F.look});
  figure.reaches = {{at.in.E.id, point}, {at.in.F.id, point}};
  return figure;
}

/// The plane E turned about its point, until its normal is a multiple of the other's or perpendicular to it.
std::vector<SpecialCase> turned(const Out &at) {
  const auto turned = turnedParallel(at.in.E.object, at.in.F.object);
  if (!turned)
    return {};
  const ExactVec3 across = projectVector(at.in.E.object.normal, at.in.F.object.normal).rejection;
  return {{is("case", turned->isTheOther ? "coincident" : "parallel"),
           turned->isTheOther ? words("{E} and {F} would be the same plane.", at.letters)
                              : words("The planes would be parallel."),
           "E", turned->plane},
          {is("cos_angle", "0"), words("The planes would stand at a right angle to each other."), "E",
           PlaneObject{at.in.E.object.point, across}}};
}

std::vector<SpecialCase> nearby(const Out &at) {
  switch (at.meet.which) {
  case PlanePlaneCase::Line:
    return turned(at);
  case PlanePlaneCase::Parallel:
    return {{is("case", "coincident"), words("{E} and {F} would be the same plane.", at.letters), "E",
             slidInto(at.in.E.object, at.in.F.object)}};
  case PlanePlaneCase::Coincident:
  case PlanePlaneCase::ZeroNormal:
    break;
  }
  return {};
}

} // namespace

Construction plane_plane() {
  return taught<Out, PlaneObject, PlaneObject>(
      {.id = "plane-plane",
       .word = "intersect",
       .title = [] { return words("line of intersection"); },
       .roles = {"E", "F"},
       .makes = {{"g", LineObject::kind, &Out::hasLine,
                  [](const Out &at) {
                    return LineObject{at.meet.nearest, at.meet.line.direction};
                  }}},
       .letters = {"m", "φ"},
       .cases = {"line", "parallel", "coincident", "zero-normal"},
       .values = {{named::vector("direction"), &Out::hasLine, &Out::v},
                  {named::vector("moment"), &Out::hasLine, &Out::m},
                  {named::vector("point"), &Out::hasLine, &Out::A},
                  {named::number("cos_angle"), &Out::hasPlanes, &Out::cosine}},
       .lines = {{"d1", &Out::hasPlanes, [](const Out &at) { return givenConstantLine(at.in.E); }},
                 {"d2", &Out::hasPlanes, [](const Out &at) { return givenConstantLine(at.in.F); }},
                 {"direction", &Out::hasPlanes, directionLine},
                 {"moment", &Out::hasLine,
                  [](const Out &at) { return withNumbers(at.m == at.d1 * at.F.n - at.d2 * at.E.n); },
                  momentWords},
                 {"point", &Out::hasLine,
                  [](const Out &at) { return withNumbers(at.A == cross(at.v, at.m) / dot(at.v, at.v)); },
                  pointWords},
                 {"angle", &Out::hasPlanes, angleLine}},
       .marks = {"g", "g.v", "g.A", "phi"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
