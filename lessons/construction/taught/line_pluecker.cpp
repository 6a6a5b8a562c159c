// The six numbers of a line, its Plücker coordinates: direction and moment (note PL).
#include "geometry/line.h"
#include "geometry/point_line.h"
#include "lessons/construction/construction.h"
#include "lessons/construction/parts/line_moment.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kinds/line.h"
#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<LineObject> g;
};

struct Out : Naming, LineTerms {
  Line<Rational> line;
  bool isReal;
  Term m;
  Term N, dist; ///< the line's point nearest to the origin, and how far from it that is
};

Symbol distanceLetter(const In &in) {
  Symbol letter = word("dist");
  letter.owner = in.g.id;
  return letter;
}

Out compute(const In &in) {
  const auto &[point, direction] = in.g.object;
  const auto line = lineAlong(point, direction);
  const bool isReal = halfspace::isReal(line);
  const auto origin = measurePointLine(ExactVec3(0), point, direction);
  return {in,
          termsOf(in.g),
          line,
          isReal,
          momentOf(in.g).marked(in.mark("m")),
          name(besideLettersOf(in.g, letter("N")), isReal ? nearestToOrigin(line) : ExactVec3(0))
              .marked(in.mark("N")),
          name(distanceLetter(in), origin.distance).marked(in.mark("dist"))};
}

CaseWords tell(const In &, const Out &at) {
  if (!at.isReal)
    return {
        "zero-direction",
        words("The direction {v} is the zero vector: it points nowhere, so there is no line.", at.letters),
        true};
  if (passesThroughOrigin(at.line))
    return {"line",
            words("The moment is the zero vector: the line {g} goes through the origin.", at.letters)};
  return {"line", words("The six numbers of the line {g} are {direction} and {moment}.", at.letters,
                        {{"direction", equation(at.v)}, {"moment", equation(at.m)}})};
}

std::string truth(bool holds) { return holds ? "true" : "false"; }

std::vector<NamedValue> valuesOf(const In &, const Out &at) {
  if (!at.isReal)
    return {};
  return {listed("direction", at.v),
          listed("moment", at.m),
          listed("relation", dot(at.v, at.m)),
          {"through_origin", words("through the origin"), truth(passesThroughOrigin(at.line))},
          listed("nearest_to_origin", at.N),
          listed("origin_distance", at.dist)};
}

std::vector<MadeObject> make(const In &, const Out &) { return {}; }

WorkingLine momentLine(const Out &at) {
  return asked(withProducts(at.m == cross(at.A, at.v)),
               passesThroughOrigin(at.line)
                   ? words("The moment: the zero vector, because the line goes through the origin.")
                   : words("The moment: perpendicular to the line, and to the way from the origin to {A}.",
                           at.letters),
               {{cross(at.v, at.A),
                 words("{answer} is the cross product the other way round: {v} × {A}.", at.letters)}});
}

WorkingLine sameLine(const Out &at) {
  return asked(withProducts(cross(at.N, at.v)),
               vectorOf(at.N) == vectorOf(at.A)
                   ? words("{point} is {A} itself here, so the moment is the same.", at.letters,
                           {{"point", equation(at.N)}})
                   : words("{point} is another point of the line, and gives the same moment as {A}.",
                           at.letters, {{"point", equation(at.N)}}),
               {{cross(at.v, at.N),
                 words("{answer} is the cross product the other way round: begin with the point.")}});
}

WorkingLine scaledLine(const Out &at) {
  return line(withResult(cross(at.A, 2 * at.v)),
              words("Twice the direction gives twice the moment: six other numbers for the same line."));
}

WorkingLine relationLine(const Out &at) {
  return asked(withProducts(dot(at.v, at.m)),
               passesThroughOrigin(at.line)
                   ? words("Always 0, and here the cross product {A} × {v} is the zero vector.", at.letters)
                   : words("Always 0: the cross product {A} × {v} is perpendicular to {v}.", at.letters));
}

WorkingLine nearestLine(const Out &at) {
  return asked(withNumbers(at.N == cross(at.v, at.m) / dot(at.v, at.v)),
               words("The point of the line that is nearest to the origin."),
               {{cross(at.m, at.v) / dot(at.v, at.v),
                 words("{answer} is on the other side of the origin: the direction comes first.")}});
}

WorkingLine distanceLine(const Out &at) {
  return asked(withNumbers(at.dist == norm(at.m) / norm(at.v)),
               passesThroughOrigin(at.line)
                   ? words("A moment of zero: the line goes through the origin.")
                   : words("How far the line is from the origin. |{m}| alone says it only when |{v}| = 1.",
                           at.letters, {{"m", plainText(at.m)}}),
               {{norm(at.m) / dot(at.v, at.v),
                 words("{answer} is divided by {v}·{v}: divide by its root, |{v}|.", at.letters)}});
}

Explanation explain(const In &, const Out &at) {
  Explanation lines;
  if (!at.isReal)
    return lines;
  lines.add("moment", [&at] { return momentLine(at); });
  lines.add("scaled", [&at] { return scaledLine(at); });
  lines.add("relation", [&at] { return relationLine(at); });
  lines.add("nearest", [&at] { return nearestLine(at); });
  lines.add("same", [&at] { return sameLine(at); });
  lines.add("distance", [&at] { return distanceLine(at); });
  return lines;
}

/// The moment stands on the plane through the origin and the line: the triangle from the origin to v.
void drawMoment(Figure &figure, const In &in, const Out &at) {
  const Place start = place(at.A);
  const Place tip = start + place(at.v);
  figure.add(momentArrow(at.m, in.g.look));
  PolygonMark triangle{{at.m->mark + "/triangle", Role::Helper, Subject::Measure}, {}};
  triangle.corners = {Place(0), start, tip};
  figure.add(std::move(triangle));
  figure.add(
      RightAngleMark{{at.m->mark + "/angle", Role::Helper, Subject::Measure}, Place(0), place(at.m), start});
}

/// The way from the origin to the nearest point.
void drawDistance(Figure &figure, const Out &at) {
  const Place nearest = place(at.N);
  figure.add(SegmentMark{drawn(at.dist, Role::Result, Subject::Measure), Place(0), nearest});
  figure.add(RightAngleMark{
      {at.dist->mark + "/angle", Role::Helper, Subject::Measure}, nearest, -nearest, place(at.v)});
}

Figure draw(const In &in, const Out &at) {
  Figure figure;
  if (!at.isReal)
    return figure;
  figure.reaches = {{in.g.id, place(at.N)}};
  if (!passesThroughOrigin(at.line)) {
    drawMoment(figure, in, at);
    drawDistance(figure, at);
  }
  figure.add(pointOf(at.N, Role::Result, Subject::Measure));
  return figure;
}

std::vector<SpecialCase> nearby(const In &in, const Out &at) {
  if (!at.isReal || passesThroughOrigin(at.line))
    return {};
  const auto &[point, direction] = in.g.object;
  return {{"through_origin = true", words("The line would go through the origin."), "g",
           LineObject{point - nearestToOrigin(at.line), direction}}};
}

} // namespace

Construction line_pluecker() {
  return makeConstruction<In, Out, LineObject>(
      "line-pluecker", {"g"}, {}, {},
      {.cases = {"line", "zero-direction"},
       .values = {named::vector("direction"), named::vector("moment"), named::number("relation"),
                  named::word("through_origin", {"true", "false"}), named::vector("nearest_to_origin"),
                  named::number("origin_distance")},
       .lines = {"moment", "scaled", "relation", "nearest", "same", "distance"},
       .marks = {"m", "dist", "N"}},
      {compute, tell, valuesOf, make, explain, draw, nearby});
}

} // namespace halfspace
