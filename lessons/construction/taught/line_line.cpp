// How two lines lie to each other, by Plücker coordinates: their permuted inner product (note PL).
#include "geometry/case_names.h"
#include "geometry/point_line.h"
#include "geometry/project_vector.h"
#include "geometry/relate_lines.h"
#include "lessons/construction/parts/line_moment.h"
#include "lessons/construction/parts/plucker_edges.h"
#include "lessons/construction/parts/value_words.h"
#include "lessons/construction/taught.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace halfspace {
namespace {

struct In : Naming {
  Given<LineObject> g;
  Given<LineObject> h;
};

/// In steps of the line's direction, from its own point.
Rational stepsTo(const ExactVec3 &point, const LineObject &line) {
  return measurePointLine(point, line.point, line.direction).t;
}

struct Out : Computed<In> {
  explicit Out(const In &objects) : Computed(objects) {}

  Line<Rational> first = lineAlong(in.g.object.point, in.g.object.direction);
  Line<Rational> second = lineAlong(in.h.object.point, in.h.object.direction);
  LineLine<Rational> related = relateLines(first, second);
  bool areLines = related.which != LineLineCase::NotALine;
  bool isCrossing = related.which == LineLineCase::Skew || related.which == LineLineCase::Intersecting;
  ExactVec3 common = cross(first.direction, second.direction);
  /// Where the directions are no multiples of each other.
  NearestPoints<Rational> nearest = isZero(common) ? NearestPoints<Rational>{} : nearestPoints(first, second);

  LineTerms g = termsOf(in.g);
  LineTerms h = termsOf(in.h);
  Term m1 = momentOf(in.g).marked(mark("m1"));
  Term m2 = momentOf(in.h).marked(mark("m2"));
  Term p = ownName(letter("p"), related.product);
  /// The volume of the tetrahedron that has the two directions, from the lines' points, as opposite edges.
  Term T = ownName(letter("T"), Rational(abs(related.product) / 6)).marked(mark("tetrahedron"));
  Term c = ownName(vectorLetter("c"), common);
  Term s = ownName(letter("s"), stepsTo(nearest.first, in.g.object));
  Term t = ownName(letter("t"), stepsTo(nearest.second, in.h.object));
  // The points where the lines come nearest to each other.
  Term F = madeName("F", nearest.first);
  Term G = madeName("G", nearest.second);
  Term dist = ownName(word("dist"), related.distance).marked(mark("dist"));
};

CaseWords tell(const Out &at) {
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
  return zeroLinesWords(at, caseName, isZero(at.in.g.object.direction), isZero(at.in.h.object.direction));
}

WorkingLine productLine(const Out &at) {
  const Term both = dot(at.g.v, at.m2) + dot(at.h.v, at.m1);
  const Chain inSymbols = (at.p == permuted(at.g.v, at.m1, at.h.v, at.m2)) == both;
  return asked(inSymbols.then(multipliedOut(both)).then(numbersPutIn(both)).then(calculated(both)),
               words("The direction of each line with the moment of the other."),
               productMistakes(at.g.v, at.m1, at.h.v, at.m2));
}

std::string signWords(const Out &at) {
  if (at.related.product > 0)
    return words("Positive: seen with {g.v} pointing at you, {h} passes {g} counterclockwise.", at.letters);
  if (at.related.product < 0)
    return words("Negative: seen with {g.v} pointing at you, {h} passes {g} clockwise.", at.letters);
  return at.isCrossing
             ? words("Zero, and the directions are no multiples of each other: the lines meet.")
             : words("Zero: the directions are multiples of each other, so neither line passes the other.");
}

WorkingLine signLine(const Out &at) { return line(compared(at.p, 0), signWords(at)); }

WorkingLine tetrahedronLine(const Out &at) {
  return asked(withNumbers(at.T == norm(at.p) / 6),
               at.related.product != 0
                   ? words("The volume of the tetrahedron with the two arrows as opposite edges.")
                   : words("0: the ends of the two arrows lie in one plane."));
}

std::string cosineWords(const Out &at) {
  return at.related.perpendicular
             ? words("Zero: the directions are perpendicular. The lines need not meet for that.")
             : words("The lines are perpendicular when this is 0.");
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
  if (!at.isCrossing)
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

/// How many steps along a line lead to its nearest point, where `across` is the other line's direction.
Chain stepsAlong(const Out &at, const Term &steps, const Term &across) {
  return withNumbers(steps == dot(cross(at.h.A - at.g.A, across), at.c) / dot(at.c, at.c));
}

LineTable<Out> lines() {
  return {
      {"m1", &Out::areLines,
       [](const Out &at) {
         return momentLine(at.m1, at.g.A, at.g.v,
                           words("The moment of {g}, the same for every point of it.", at.letters));
       }},
      {"m2", &Out::areLines,
       [](const Out &at) {
         return momentLine(at.m2, at.h.A, at.h.v, words("The moment of {h}.", at.letters));
       }},
      {"product", &Out::areLines, productLine},
      {"sign", &Out::areLines, signLine},
      {"tetrahedron", &Out::areLines, tetrahedronLine},
      {"perpendicular", &Out::areLines, [](const Out &at) { return withProducts(dot(at.g.v, at.h.v)); },
       cosineWords},
      {"c", &Out::areLines, commonLine},
      {"distance", &Out::areLines, distanceLine},
      {"s", &Out::isCrossing, [](const Out &at) { return stepsAlong(at, at.s, at.h.v); },
       says("It takes this many steps {g.v} along {g} to get where the lines come nearest.")},
      {"foot1", &Out::isCrossing, [](const Out &at) { return withNumbers(at.F == at.g.A + at.s * at.g.v); },
       says("The point of {g} that is nearest to {h}.")},
      {"t", &Out::isCrossing, [](const Out &at) { return stepsAlong(at, at.t, at.g.v); },
       says("It takes this many steps {h.v} to get there along {h}.")},
      {"foot2", &Out::isCrossing, [](const Out &at) { return withNumbers(at.G == at.h.A + at.t * at.h.v); },
       says("The point of {h} that is nearest to {g}.")}};
}

void drawMoments(Figure &figure, const Out &at) {
  for (const auto &[moment, look] : {std::pair(at.m1, at.in.g.look), std::pair(at.m2, at.in.h.look)})
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

void drawTetrahedron(Figure &figure, const Out &at) {
  const std::array corners{place(at.g.A), place(at.g.A) + place(at.g.v), place(at.h.A),
                           place(at.h.A) + place(at.h.v)};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    figure.add(PolygonMark{
        {partOf(at.T->mark, i), Role::Derived, Subject::Measure},
        {corners.at(i), corners.at((i + 1) % corners.size()), corners.at((i + 2) % corners.size())}});
  }
}

/// How the second line passes the first: a curved arrow around the first, from the way between the lines
/// towards where the second one goes.
void drawTurn(Figure &figure, const Out &at) {
  constexpr int pieces = 18;
  constexpr double angle = 1.5 * std::numbers::pi;
  const std::string id = at.mark("turn");
  const Place centre = place(at.F);
  const double radius = glm::length(place(at.G) - centre) / 2;
  const Place start = unitOf(at.nearest.second - at.nearest.first);
  const Place axis = unitOf(at.in.g.object.direction) * (at.related.product > 0 ? 1.0 : -1.0);
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

Figure draw(const Out &at) {
  Figure figure;
  if (!at.areLines)
    return figure;
  drawMoments(figure, at);
  if (at.related.which == LineLineCase::Parallel) {
    const auto &[point, direction] = at.in.h.object;
    const ExactVec3 foot = measurePointLine(at.in.g.object.point, point, direction).foot;
    drawWay(figure, at, place(at.g.A), place(foot));
    figure.reaches = {{at.in.h.id, place(foot)}};
  }
  if (!at.isCrossing)
    return figure;
  figure.add(pointOf(at.F, Role::Result, Subject::Measure));
  figure.add(pointOf(at.G, Role::Result, Subject::Measure));
  figure.reaches = {{at.in.g.id, place(at.F)}, {at.in.h.id, place(at.G)}};
  if (at.related.which == LineLineCase::Skew) {
    drawWay(figure, at, place(at.F), place(at.G));
    drawTurn(figure, at);
    drawTetrahedron(figure, at);
  }
  return figure;
}

/// The second line turned about its point, until it is parallel or perpendicular to the first.
void addTurned(const Out &at, std::vector<SpecialCase> &all) {
  const auto &[point, direction] = at.in.h.object;
  const auto parts = projectVector(direction, at.in.g.object.direction);
  if (at.related.perpendicular)
    return; // it is perpendicular already, and would vanish along the first
  all.push_back({is("perpendicular", "true"), words("The lines would be perpendicular."), "h",
                 LineObject{point, parts.rejection}});
  const LineObject turned{point, parts.projection};
  const auto which = relateLines(lineAlong(at.in.g.object.point, at.in.g.object.direction),
                                 lineAlong(turned.point, turned.direction))
                         .which;
  all.push_back({is("case", nameOf(which)),
                 which == LineLineCase::Parallel ? words("The lines would be parallel.")
                                                 : words("{g} and {h} would be the same line.", at.letters),
                 "h", turned});
}

std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  const auto &[point, direction] = at.in.h.object;
  if (at.related.which == LineLineCase::Skew)
    all.push_back({is("case", "intersecting"), words("The lines would meet."), "h",
                   LineObject{point - ExactVec3(at.nearest.second - at.nearest.first), direction}});
  if (at.isCrossing)
    addTurned(at, all);
  if (at.related.which == LineLineCase::Parallel) {
    const ExactVec3 foot = measurePointLine(point, at.in.g.object.point, at.in.g.object.direction).foot;
    const bool isSame = dot(direction, at.in.g.object.direction) > 0;
    all.push_back({is("case", isSame ? "same" : "opposite"),
                   words("{g} and {h} would be the same line.", at.letters), "h",
                   LineObject{foot, direction}});
  }
  return all;
}

} // namespace

Construction line_line() {
  return taught<Out, LineObject, LineObject>(
      {.id = "line-line",
       .word = "intersect",
       .title = [] { return words("where the lines meet"); },
       .roles = {"g", "h"},
       .makes = {{"F", &Out::isCrossing, &Out::F}, {"G", &Out::isCrossing, &Out::G}},
       .letters = {"p", "T", "c", "s", "t", "dist"},
       .cases = {"same", "opposite", "parallel", "intersecting", "skew", "not-a-line"},
       .values = {{named::number("product"), &Out::areLines, &Out::p},
                  {named::number("tetrahedron"), &Out::areLines, &Out::T},
                  {named::word("perpendicular", {"true", "false"}), &Out::areLines,
                   [](const Out &at) {
                     return ToldValue(words("perpendicular"), trueOrFalse(at.related.perpendicular));
                   }},
                  {named::number("distance"), &Out::areLines, &Out::dist},
                  {named::vector("point"),
                   [](const Out &at) { return at.related.which == LineLineCase::Intersecting; }, &Out::F}},
       .lines = lines(),
       .marks = {"m1", "m2", "tetrahedron", "dist", "turn", "F", "G"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
