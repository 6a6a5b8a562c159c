// How two lines lie to each other, by Plücker coordinates: their permuted inner product (note PL).
#include "lessons/object/kinds/line.h"
#include "geometry/case_names.h"
#include "geometry/point_line.h"
#include "geometry/project_vector.h"
#include "geometry/relate_lines.h"
#include "lessons/construction/construction.h"
#include "lessons/construction/parts/line_moment.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "lessons/words.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace halfspace {
namespace {

struct In : Naming {
  Given<LineObject> g;
  Given<LineObject> h;
};

struct Out : Naming {
  LineLine<Rational> related;
  NearestPoints<Rational> nearest; ///< where the directions are no multiples of each other
  LineTerms g, h;
  Term m1, m2; ///< the moments
  Term p;      ///< the permuted inner product
  Term c;      ///< perpendicular to both directions
  Term s, t;   ///< of F and G, in steps of the directions
  Term F, G;   ///< the points where the lines come nearest to each other
  Term dist;

  [[nodiscard]] bool isCrossing() const {
    return related.which == LineLineCase::Skew || related.which == LineLineCase::Intersecting;
  }
};

/// In steps of the line's direction, from its own point.
Rational stepsTo(const ExactVec3 &point, const LineObject &line) {
  return measurePointLine(point, line.point, line.direction).t;
}

Out compute(const In &in) {
  const auto first = lineAlong(in.g.object.point, in.g.object.direction);
  const auto second = lineAlong(in.h.object.point, in.h.object.direction);
  const auto related = relateLines(first, second);
  const ExactVec3 common = cross(first.direction, second.direction);
  const auto nearest = isZero(common) ? NearestPoints<Rational>{} : nearestPoints(first, second);
  return {in,
          related,
          nearest,
          termsOf(in.g),
          termsOf(in.h),
          momentOf(in.g).marked(in.mark("m1")),
          momentOf(in.h).marked(in.mark("m2")),
          name(in.own(letter("p")), related.product),
          name(in.own(vectorLetter("c")), common),
          name(in.own(letter("s")), stepsTo(nearest.first, in.g.object)),
          name(in.own(letter("t")), stepsTo(nearest.second, in.h.object)),
          madeName(in, "F", nearest.first),
          madeName(in, "G", nearest.second),
          name(in.own(word("dist")), related.distance).marked(in.mark("dist"))};
}

std::string notALineWords(const In &in, const Out &at) {
  const bool isFirst = isZero(in.g.object.direction);
  if (isFirst && isZero(in.h.object.direction))
    return words("{g.v} and {h.v} are zero vectors: they point nowhere, so there are no lines.", at.letters);
  return isFirst ? words("{g.v} is the zero vector: it points nowhere, so {g} is no line.", at.letters)
                 : words("{h.v} is the zero vector: it points nowhere, so {h} is no line.", at.letters);
}

CaseWords tell(const In &in, const Out &at) {
  const std::string caseName(nameOf(at.related.which));
  switch (at.related.which) {
  case LineLineCase::Same:
    return {caseName, words("{g} and {h} are the same line, with directions that agree.", at.letters)};
  case LineLineCase::Opposite:
    return {caseName, words("{g} and {h} are the same line, with opposite directions.", at.letters)};
  case LineLineCase::Parallel:
    return {caseName,
            words("The directions are multiples of each other, and no point lies on both lines: {g} and {h} "
                  "are parallel.",
                  at.letters)};
  case LineLineCase::Intersecting:
    return {caseName,
            words("The directions differ, and one point lies on both lines: {g} and {h} meet.", at.letters)};
  case LineLineCase::Skew:
    return {caseName,
            words("No plane contains both lines: {g} and {h} are skew, they pass each other.", at.letters)};
  case LineLineCase::NotALine:
    break;
  }
  return {caseName, notALineWords(in, at), true};
}

std::vector<NamedValue> valuesOf(const In &, const Out &at) {
  if (at.related.which == LineLineCase::NotALine)
    return {};
  std::vector<NamedValue> values{
      listed("product", at.p),
      {"perpendicular", words("perpendicular"), at.related.perpendicular ? "true" : "false"},
      listed("distance", at.dist)};
  if (at.related.which == LineLineCase::Intersecting)
    values.push_back(listed("point", at.F));
  return values;
}

std::vector<MadeObject> make(const In &, const Out &at) {
  if (!at.isCrossing())
    return {};
  return {{"F", PointObject{at.nearest.first}}, {"G", PointObject{at.nearest.second}}};
}

/// `sentence` says which line's it is.
WorkingLine momentLine(const Term &moment, const LineTerms &line, std::string sentence) {
  return asked(withProducts(moment == cross(line.A, line.v)), std::move(sentence),
               {{cross(line.v, line.A),
                 words("{answer} is the cross product the other way round: begin with the point.")}});
}

WorkingLine productLine(const Out &at) {
  const Term both = dot(at.g.v, at.m2) + dot(at.h.v, at.m1);
  const Chain inSymbols = (at.p == permuted(at.g.v, at.m1, at.h.v, at.m2)) == both;
  return asked(inSymbols.then(multipliedOut(both)).then(numbersPutIn(both)).then(calculated(both)),
               words("The direction of each line with the moment of the other."),
               {{dot(at.g.v, at.h.v) + dot(at.m1, at.m2),
                 words("{answer} multiplies direction by direction and moment by moment: cross over, each "
                       "direction with the other line's moment.")},
                {dot(at.g.v, at.m1) + dot(at.h.v, at.m2),
                 words("{answer} multiplies each direction by its own line's moment: take the other's.")},
                {dot(at.g.v, at.m2) - dot(at.h.v, at.m1),
                 words("{answer} subtracts the second product: the two are added.")}});
}

std::string signWords(const Out &at) {
  if (at.related.product > 0)
    return words("Positive: seen with {g.v} pointing at you, {h} passes {g} counterclockwise.", at.letters);
  if (at.related.product < 0)
    return words("Negative: seen with {g.v} pointing at you, {h} passes {g} clockwise.", at.letters);
  return at.isCrossing()
             ? words("Zero, and the directions are no multiples of each other: the lines meet.")
             : words("Zero: the directions are multiples of each other, so neither line passes the other.");
}

WorkingLine cosineLine(const Out &at) {
  return asked(withProducts(dot(at.g.v, at.h.v)),
               at.related.perpendicular
                   ? words("Zero: the directions are perpendicular. The lines need not meet for that.")
                   : words("The lines are perpendicular when this is 0."));
}

std::string commonWords(const Out &at) {
  switch (at.related.which) {
  case LineLineCase::Skew:
    return words("Perpendicular to both lines: the shortest way between them runs along it.");
  case LineLineCase::Intersecting:
    return words("Perpendicular to both lines, and so to the plane in which they meet.");
  default:
    return words("The zero vector: the directions are multiples of each other.");
  }
}

WorkingLine commonLine(const Out &at) {
  return asked(withProducts(at.c == cross(at.g.v, at.h.v)), commonWords(at),
               {{cross(at.h.v, at.g.v),
                 words("{answer} is the cross product the other way round: {h.v} × {g.v}.", at.letters)}});
}

WorkingLine distanceLine(const Out &at) {
  if (!at.isCrossing())
    return asked(
        withNumbers(at.dist == norm(cross(at.h.A - at.g.A, at.g.v)) / norm(at.g.v)),
        at.related.which == LineLineCase::Parallel
            ? words("How far {h.A} is from {g}: with parallel lines every point is equally far.", at.letters)
            : words("Zero: {h.A} lies on {g}, as every point of the same line does.", at.letters));
  return asked(withNumbers(at.dist == norm(at.p) / norm(at.c)),
               at.related.which == LineLineCase::Intersecting
                   ? words("Zero: the lines meet.")
                   : words("The distance of the lines: a length, so without the sign of the product."),
               {{norm(at.p) / dot(at.c, at.c), words("{answer} is divided by c·c: divide by its root, |c|.")},
                {norm(at.p), words("{answer} is the product without its sign: divide it by |c|.")}});
}

/// How many steps `along` lead to the nearest point, where `across` is the other line's direction.
WorkingLine stepsLine(const Out &at, const Term &steps, const Term &across, std::string sentence) {
  return asked(withNumbers(steps == dot(cross(at.h.A - at.g.A, across), at.c) / dot(at.c, at.c)),
               std::move(sentence));
}

WorkingLine footLine(const Term &foot, const LineTerms &line, const Term &steps, std::string sentence) {
  return asked(withNumbers(foot == line.A + steps * line.v), std::move(sentence));
}

void addFeet(const Out &at, Explanation &lines) {
  lines.add("s", [&at] {
    return stepsLine(
        at, at.s, at.h.v,
        words("So many steps {g.v} lead along {g} to where the lines come nearest.", at.letters));
  });
  lines.add("foot1", [&at] {
    return footLine(at.F, at.g, at.s, words("The point of {g} that is nearest to {h}.", at.letters));
  });
  lines.add("t", [&at] {
    return stepsLine(at, at.t, at.g.v, words("So many steps {h.v} lead there along {h}.", at.letters));
  });
  lines.add("foot2", [&at] {
    return footLine(at.G, at.h, at.t, words("The point of {h} that is nearest to {g}.", at.letters));
  });
}

Explanation explain(const In &, const Out &at) {
  Explanation lines;
  if (at.related.which == LineLineCase::NotALine)
    return lines;
  lines.add("m1", [&at] {
    return momentLine(at.m1, at.g, words("The moment of {g}, the same for every point of it.", at.letters));
  });
  lines.add("m2", [&at] { return momentLine(at.m2, at.h, words("The moment of {h}.", at.letters)); });
  lines.add("product", [&at] { return productLine(at); });
  lines.add("sign", [&at] { return line(compared(at.p, 0), signWords(at)); });
  lines.add("perpendicular", [&at] { return cosineLine(at); });
  lines.add("c", [&at] { return commonLine(at); });
  lines.add("distance", [&at] { return distanceLine(at); });
  if (at.isCrossing())
    addFeet(at, lines);
  return lines;
}

void drawMoments(Figure &figure, const In &in, const Out &at) {
  for (const auto &[moment, look] : {std::pair(at.m1, in.g.look), std::pair(at.m2, in.h.look)})
    if (!isZero(vectorOf(moment)))
      figure.add(momentArrow(moment, look));
}

/// The shortest way between the lines, with a right angle at each of them.
void drawWay(Figure &figure, const Out &at, const Place &from, const Place &to) {
  const std::string &id = at.dist->mark;
  figure.add(SegmentMark{drawn(at.dist, Role::Result, Subject::Measure), from, to});
  figure.add(RightAngleMark{{id + "/first", Role::Helper, Subject::Measure}, from, to - from, place(at.g.v)});
  figure.add(RightAngleMark{{id + "/second", Role::Helper, Subject::Measure}, to, from - to, place(at.h.v)});
}

/// How the second line passes the first: a curved arrow around the first, from the way between the lines
/// towards where the second one goes.
void drawTurn(Figure &figure, const In &in, const Out &at) {
  constexpr int pieces = 18;
  constexpr double angle = 1.5 * std::numbers::pi;
  const std::string id = in.mark("turn");
  const Place centre = place(at.F);
  const double radius = glm::length(place(at.G) - centre) / 2;
  const Place start = unitOf(at.nearest.second - at.nearest.first);
  const Place axis = unitOf(in.g.object.direction) * (at.related.product > 0 ? 1.0 : -1.0);
  const Place across = glm::cross(axis, start);
  const auto point = [&](int piece) {
    const double turned = angle * piece / pieces;
    return centre + radius * (start * std::cos(turned) + across * std::sin(turned));
  };
  for (int piece = 0; piece + 2 < pieces; ++piece)
    figure.add(SegmentMark{
        {id + "/" + std::to_string(piece), Role::Derived, Subject::Neutral}, point(piece), point(piece + 1)});
  figure.add(
      ArrowMark{{id, Role::Derived, Subject::Neutral}, point(pieces - 2), point(pieces) - point(pieces - 2)});
}

Figure draw(const In &in, const Out &at) {
  Figure figure;
  if (at.related.which == LineLineCase::NotALine)
    return figure;
  drawMoments(figure, in, at);
  if (at.related.which == LineLineCase::Parallel) {
    const auto &[point, direction] = in.h.object;
    const ExactVec3 foot = measurePointLine(in.g.object.point, point, direction).foot;
    drawWay(figure, at, place(at.g.A), place(foot));
    figure.reaches = {{in.h.id, place(foot)}};
  }
  if (!at.isCrossing())
    return figure;
  figure.add(pointOf(at.F, Role::Result, Subject::Measure));
  figure.add(pointOf(at.G, Role::Result, Subject::Measure));
  figure.reaches = {{in.g.id, place(at.F)}, {in.h.id, place(at.G)}};
  if (at.related.which == LineLineCase::Skew) {
    drawWay(figure, at, place(at.F), place(at.G));
    drawTurn(figure, in, at);
  }
  return figure;
}

/// The second line turned about its point, until it is parallel or perpendicular to the first.
void addTurned(const In &in, const Out &at, std::vector<SpecialCase> &all) {
  const auto &[point, direction] = in.h.object;
  const auto parts = projectVector(direction, in.g.object.direction);
  if (at.related.perpendicular)
    return; // it is perpendicular already, and would vanish along the first
  all.push_back({"perpendicular = true", words("The lines would be perpendicular."), "h",
                 LineObject{point, parts.rejection}});
  const LineObject turned{point, parts.projection};
  const auto which = relateLines(lineAlong(in.g.object.point, in.g.object.direction),
                                 lineAlong(turned.point, turned.direction))
                         .which;
  all.push_back({"case = " + std::string(nameOf(which)),
                 which == LineLineCase::Parallel ? words("The lines would be parallel.")
                                                 : words("{g} and {h} would be the same line.", at.letters),
                 "h", turned});
}

std::vector<SpecialCase> nearby(const In &in, const Out &at) {
  std::vector<SpecialCase> all;
  const auto &[point, direction] = in.h.object;
  if (at.related.which == LineLineCase::Skew)
    all.push_back({"case = intersecting", words("The lines would meet."), "h",
                   LineObject{point - ExactVec3(at.nearest.second - at.nearest.first), direction}});
  if (at.isCrossing())
    addTurned(in, at, all);
  if (at.related.which == LineLineCase::Parallel) {
    const ExactVec3 foot = measurePointLine(point, in.g.object.point, in.g.object.direction).foot;
    const bool isSame = dot(direction, in.g.object.direction) > 0;
    all.push_back({isSame ? "case = same" : "case = opposite",
                   words("{g} and {h} would be the same line.", at.letters), "h",
                   LineObject{foot, direction}});
  }
  return all;
}

} // namespace

Construction line_line() {
  return makeConstruction<In, Out, LineObject, LineObject>(
      "line-line", {"g", "h"}, {{"F", "point"}, {"G", "point"}}, {"p", "c", "s", "t", "dist"},
      {.cases = {"same", "opposite", "parallel", "intersecting", "skew", "not-a-line"},
       .values = {named::number("product"), named::word("perpendicular", {"true", "false"}),
                  named::number("distance"), named::vector("point")},
       .lines = {"m1", "m2", "product", "sign", "perpendicular", "c", "distance", "s", "foot1", "t", "foot2"},
       .marks = {"m1", "m2", "dist", "turn", "F", "G"}},
      {compute, tell, valuesOf, make, explain, draw, nearby});
}

} // namespace halfspace
