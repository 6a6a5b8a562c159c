// The line that two planes have in common, by Plücker coordinates (note PL; its point nearest to the origin).
#include "lessons/object/kinds/plane.h"
#include "geometry/case_names.h"
#include "geometry/intersect_planes.h"
#include "geometry/project_vector.h"
#include "lessons/construction/construction.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kinds/line.h"
#include "lessons/object/letters.h"
#include "lessons/term/angle.h"
#include "lessons/term/latex.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<PlaneObject> E;
  Given<PlaneObject> F;
};

struct Out : Naming {
  PlanePlane<Rational> meet;
  PlaneTerms E, F;
  Term d1, d2;      ///< the planes' constants
  Term v, m;        ///< direction and moment of the line
  Term A;           ///< its point nearest to the origin
  Term phi, cosine; ///< of the angle between the normals
};

/// d of a plane: −n·P0.
Term constantOf(const PlaneTerms &plane, const std::string &owner, const Rational &value) {
  Symbol d = letter("d");
  d.owner = owner;
  return name(std::move(d), value).standingFor(-dot(plane.n, plane.P0));
}

Out compute(const In &in) {
  const auto first = planeThrough(in.E.object.point, in.E.object.normal);
  const auto second = planeThrough(in.F.object.point, in.F.object.normal);
  const auto meet = intersectPlanes(first, second);
  const PlaneTerms E = termsOf(in.E);
  const PlaneTerms F = termsOf(in.F);
  const Term phi = name(in.own(letter("φ")), std::nullopt).marked(in.mark("phi"));
  return {in,
          meet,
          E,
          F,
          constantOf(E, in.E.id, first.offset),
          constantOf(F, in.F.id, second.offset),
          madeName(in, "g", "v", meet.line.direction),
          name(in.own(vectorLetter("m")), meet.line.moment),
          madeName(in, "g", "A", meet.nearest),
          phi,
          applied(word("cos"), phi, meet.cosine)};
}

CaseWords tell(const In &, const Out &at) {
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
  return {caseName,
          words("The normal {zero} is the zero vector: it points nowhere, so there is no plane.",
                {{"zero", plainText(isZero(vectorOf(at.E.n)) ? at.E.n : at.F.n)}}),
          true};
}

std::vector<NamedValue> valuesOf(const In &, const Out &at) {
  if (at.meet.which == PlanePlaneCase::ZeroNormal)
    return {};
  std::vector<NamedValue> values;
  if (at.meet.which == PlanePlaneCase::Line)
    values = {listed("direction", at.v), listed("moment", at.m), listed("point", at.A)};
  values.push_back(listed("cos_angle", at.cosine));
  return values;
}

std::vector<MadeObject> make(const In &, const Out &at) {
  if (at.meet.which != PlanePlaneCase::Line)
    return {};
  return {{"g", LineObject{at.meet.nearest, at.meet.line.direction}}};
}

/// `sentence` says which plane's it is.
WorkingLine constantLine(const Term &d, const PlaneTerms &plane, std::string sentence) {
  return asked(withProducts(d == -dot(plane.n, plane.P0)), std::move(sentence));
}

WorkingLine directionLine(const Out &at) {
  return asked(
      withProducts(at.v == cross(at.E.n, at.F.n)),
      at.meet.which == PlanePlaneCase::Line
          ? words("The line lies in both planes, so it is perpendicular to both normals.")
          : words("The cross product is the zero vector: the normals lie along the same line, and the "
                  "planes share no single line."),
      {{cross(at.F.n, at.E.n),
        words("{answer} is the cross product the other way round: {F.n} × {E.n}.", at.letters)}});
}

WorkingLine momentLine(const Out &at) {
  return asked(
      withNumbers(at.m == at.d1 * at.F.n - at.d2 * at.E.n),
      words("The moment P × {v} is the same for every point P of the line. The two equations give it "
            "without knowing any point.",
            at.letters, {{"v", plainText(at.v)}}));
}

WorkingLine pointLine(const Out &at) {
  return asked(
      withNumbers(at.A == cross(at.v, at.m) / dot(at.v, at.v)),
      isZero(vectorOf(at.m))
          ? words("The moment is zero: the line goes through the origin, which is its nearest point.")
          : words("The point of the line that is nearest to the origin."));
}

WorkingLine angleLine(const Out &at) {
  const std::string degrees = relatedText(degreesOf(at.cosine)); // with its relation
  return asked(withNumbers(at.cosine == dot(at.E.n, at.F.n) / (norm(at.E.n) * norm(at.F.n))),
               at.meet.which != PlanePlaneCase::Line
                   ? words("φ{degrees}°: the normals lie along the same line.", {{"degrees", degrees}})
               : sign(*numberOf(at.cosine)) >= 0
                   ? words("φ{degrees}° is the angle between the normals, and so between the planes.",
                           {{"degrees", degrees}})
                   : words("φ{degrees}° is the angle between the normals. The planes meet at 180° − φ.",
                           {{"degrees", degrees}}));
}

Explanation explain(const In &, const Out &at) {
  Explanation lines;
  if (at.meet.which == PlanePlaneCase::ZeroNormal)
    return lines;
  lines.add("d1", [&at] {
    return constantLine(at.d1, at.E,
                        words("The constant d of {E}: its equation is n·P + d = 0.", at.letters));
  });
  lines.add("d2", [&at] {
    return constantLine(at.d2, at.F,
                        words("The constant d of {F}: its equation is n·P + d = 0.", at.letters));
  });
  lines.add("direction", [&at] { return directionLine(at); });
  if (at.meet.which == PlanePlaneCase::Line) {
    lines.add("moment", [&at] { return momentLine(at); });
    lines.add("point", [&at] { return pointLine(at); });
  }
  lines.add("angle", [&at] { return angleLine(at); });
  return lines;
}

/// The angle between the normals, both drawn once more from a point of the line.
void drawAngle(Figure &figure, const In &in, const Out &at, const Place &point) {
  const Place first = place(at.E.n);
  const Place second = place(at.F.n);
  figure.add(ArcMark{drawn(at.phi, Role::Derived, Subject::Neutral), point, first, second});
  const auto addNormal = [&](const char *which, const Place &normal, const Look &look) {
    const MarkBase base{at.phi->mark + which, Role::Ghost, Subject::Plane};
    figure.add(inLook(look, ArrowMark{base, point, normal, true}));
  };
  addNormal("/first", first, in.E.look);
  addNormal("/second", second, in.F.look);
}

Figure draw(const In &in, const Out &at) {
  Figure figure;
  if (at.meet.which != PlanePlaneCase::Line)
    return figure;
  const Place point = place(at.A);
  MarkBase line{in.mark("g"), Role::Result, Subject::Ray, latexOf(in.made.at("g").symbol)};
  figure.add(LineMark{std::move(line), point, unitOf(at.meet.line.direction)});
  ArrowMark direction = arrowOf(at.v, point, Role::Derived, Subject::Ray);
  direction.isFree = true;
  figure.add(std::move(direction));
  figure.add(pointOf(at.A, Role::Derived, Subject::Ray));
  drawAngle(figure, in, at, point);
  figure.reaches = {{in.E.id, point}, {in.F.id, point}};
  return figure;
}

/// The plane E turned about its point, until its normal is a multiple of the other's or perpendicular to it.
std::vector<SpecialCase> turned(const In &in, const Out &at) {
  std::vector<SpecialCase> all;
  const auto parts = projectVector(in.E.object.normal, in.F.object.normal);
  const ExactVec3 &point = in.E.object.point;
  const bool isInBoth = evaluate(planeThrough(in.F.object.point, in.F.object.normal), point) == 0;
  if (!isZero(parts.projection))
    all.push_back({isInBoth ? "case = coincident" : "case = parallel",
                   isInBoth ? words("{E} and {F} would be the same plane.", at.letters)
                            : words("The planes would be parallel."),
                   "E", PlaneObject{point, parts.projection}});
  if (!isZero(parts.rejection) && !isZero(parts.projection))
    all.push_back({"cos_angle = 0", words("The planes would stand at a right angle to each other."), "E",
                   PlaneObject{point, parts.rejection}});
  return all;
}

std::vector<SpecialCase> nearby(const In &in, const Out &at) {
  const auto &[point, normal] = in.E.object;
  switch (at.meet.which) {
  case PlanePlaneCase::Line:
    return turned(in, at);
  case PlanePlaneCase::Parallel:
    return {{"case = coincident", words("{E} and {F} would be the same plane.", at.letters), "E",
             PlaneObject{point - projectVector(ExactVec3(point - in.F.object.point), normal).projection,
                         normal}}};
  case PlanePlaneCase::Coincident:
  case PlanePlaneCase::ZeroNormal:
    break;
  }
  return {};
}

} // namespace

Construction plane_plane() {
  return makeConstruction<In, Out, PlaneObject, PlaneObject>(
      "plane-plane", {"E", "F"}, {{"g", "line"}}, {"m", "φ"},
      {.cases = {"line", "parallel", "coincident", "zero-normal"},
       .values = {named::vector("direction"), named::vector("moment"), named::vector("point"),
                  named::number("cos_angle")},
       .lines = {"d1", "d2", "direction", "moment", "point", "angle"},
       .marks = {"g", "g.v", "g.A", "phi"}},
      {compute, tell, valuesOf, make, explain, draw, nearby});
}

} // namespace halfspace
