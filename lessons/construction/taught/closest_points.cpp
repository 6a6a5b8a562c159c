// Where two lines come closest: the two equations of the common perpendicular, and their distance as the
// volume of a box over its base.
#include "geometry/closest_points.h"
#include "geometry/project_vector.h"
#include "lessons/construction/parts/spanned_box.h"
#include "lessons/construction/taught.h"
#include "lessons/object/kinds/line.h"

#include <glm/geometric.hpp>

namespace halfspace {
namespace {

struct In : Naming {
  Given<LineObject> g;
  Given<LineObject> h;
};

struct Out : Computed<In> {
  explicit Out(const In &objects) : Computed(objects) {}

  const LineObject &first = in.g.object;
  const LineObject &second = in.h.object;
  ClosestPoints<Rational> closest =
      closestPoints(first.point, first.direction, second.point, second.direction);
  bool areLines = closest.which != ClosestPointsCase::ZeroDirection;
  bool hasPair = closest.which == ClosestPointsCase::Skew || closest.which == ClosestPointsCase::Meet;
  ExactVec3 foot = measurePointLine(first.point, second.point, second.direction).foot;
  ExactVec3 back = measurePointLine(foot, first.point, first.direction).foot;

  LineTerms g = termsOf(in.g);
  LineTerms h = termsOf(in.h);
  Term w = drawnName(vectorLetter("w"), ExactVec3(second.point - first.point));
  // The shortest way from the first line's point to the second line, and from there back again.
  Term H = drawnName(letter("H"), foot);
  Term R = drawnName(letter("R"), back);
  Term n = drawnName(vectorLetter("n"), closest.normal);
  Term s = ownName(letter("s"), closest.s);
  Term t = ownName(letter("t"), closest.t);
  Term F = madeName("F", closest.first);
  Term G = madeName("G", closest.second);
  Term V = ownName(letter("V"), Rational(abs(closest.volume))).marked(mark("box"));
  Term base = norm(n).marked(mark("base")); ///< its area
  Term dist = ownName(word("dist"), closest.distance).marked(mark("dist"));
};

CaseWords tell(const Out &at) {
  switch (at.closest.which) {
  case ClosestPointsCase::Skew:
    return {"skew", words("{g} and {h} neither meet nor are parallel. {F} and {G} are closest: {dist}.",
                          at.letters, {{"dist", equation(at.dist)}})};
  case ClosestPointsCase::Meet:
    return {"meet", words("{g} and {h} meet: both closest points are the common point.", at.letters)};
  case ClosestPointsCase::Parallel:
    return {"parallel", words("{g} and {h} are parallel: every point of one is equally far from the other, "
                              "and no single pair is closest. {dist}.",
                              at.letters, {{"dist", equation(at.dist)}})};
  case ClosestPointsCase::Coincident:
    return {"coincident",
            words("{g} and {h} are the same line: every point of it lies on both.", at.letters)};
  case ClosestPointsCase::ZeroDirection:
    break;
  }
  return zeroLinesWords(at, "zero-direction", isZero(at.first.direction), isZero(at.second.direction));
}

/// Where the way there and back ends.
ToldValue backValue(const Out &at) {
  const std::string label = words("there and back");
  if (at.back == at.first.point)
    return {label, Word{"start", words("where it began")}};
  return {label, at.back == at.closest.first ? Word{"closest", words("at the closest point")}
                                             : Word{"nearer", words("at a nearer point")}};
}

/// The foot of a point on a line, as its formula.
Term footOf(const Term &point, const LineTerms &line) {
  return line.A + dot(point - line.A, line.v) / dot(line.v, line.v) * line.v;
}

std::string thereWords(const Out &at) {
  return at.foot == at.first.point ? words("{g.A} is its own foot: it lies on {h}, too.", at.letters)
                                   : words("The foot of {g.A} on {h}.", at.letters);
}

std::string backWords(const Out &at) {
  return at.back == at.first.point ? words("The foot of H on {g} is {g.A} again.", at.letters)
                                   : words("The foot of H on {g}: it is not {g.A}.", at.letters);
}

/// That the way between any two points of the lines is perpendicular to one of them.
WorkingLine equationLine(const Out &at, const Term &direction, std::string sentence) {
  const Term s = unknown("s");
  const Term t = unknown("t");
  const Term expanded = dot(at.w, direction) - dot(at.g.v, direction) * s + dot(at.h.v, direction) * t;
  return askedEquation(
      condition(
          ((0 == dot(at.w - s * at.g.v + t * at.h.v, direction)) == expanded).then(calculated(expanded))),
      std::move(sentence));
}

/// The products of the directions with each other, as the numbers before s and t.
struct Products {
  explicit Products(const Out &at)
      : gg(dot(at.g.v, at.g.v)), gh(dot(at.g.v, at.h.v)), hh(dot(at.h.v, at.h.v)), gw(dot(at.w, at.g.v)),
        hw(dot(at.w, at.h.v)) {}
  Term gg, gh, hh, gw, hw;
};

std::string determinantWords(const Out &at) {
  return at.hasPair ? words("Not 0: the directions are no multiples of each other, so exactly one s and one "
                            "t fit.")
                    : words("0: the directions are multiples of each other, so more than one s and t fit.");
}

WorkingLine determinantLine(const Out &at) {
  const Products by(at);
  return asked(withNumbers(dot(at.n, at.n) == determinant(2, {by.gg, -by.gh, -by.gh, by.hh})),
               determinantWords(at),
               {{by.gg * by.hh + power(by.gh, 2),
                 words("{answer} is a sum: the product on the diagonal that rises is subtracted.")}});
}

/// How many steps along a line lead to its closest point: a determinant over n·n.
WorkingLine stepsLine(const Out &at, const Term &steps, const Term &above, std::string sentence) {
  const Term square = dot(at.n, at.n);
  return asked((steps == above / square)
                   .then(numbersPutIn(above) / calculated(square))
                   .then(calculated(above / square)),
               std::move(sentence),
               {{above / norm(at.n), words("{answer} is divided by |n|: divide by n·n.")}});
}

WorkingLine firstStepsLine(const Out &at) {
  const Products by(at);
  return stepsLine(at, at.s, determinant(2, {by.gw, -by.gh, -by.hw, by.hh}),
                   words("So many steps {g.v} lead from {g.A} to {F}.", at.letters));
}

WorkingLine secondStepsLine(const Out &at) {
  const Products by(at);
  return stepsLine(at, at.t, determinant(2, {by.gg, by.gw, -by.gh, -by.hw}),
                   words("So many steps {h.v} lead from {h.A} to {G}.", at.letters));
}

std::string lengthWords(const Out &at) {
  return at.closest.which == ClosestPointsCase::Meet
             ? words("0: both are the common point of the lines.")
             : words("The length of the arrow from {F} to {G}.", at.letters);
}

std::string normalWords(const Out &at) {
  return at.hasPair ? words("Perpendicular to both lines.")
                    : words("The zero vector: the directions are multiples of each other.");
}

WorkingLine normalLine(const Out &at) {
  return asked(withProducts(at.n == cross(at.g.v, at.h.v)), normalWords(at),
               {{cross(at.h.v, at.g.v),
                 words("{answer} is the cross product the other way round: {h.v} × {g.v}.", at.letters)}});
}

/// Parallel lines: the parallelogram of w and the first direction has its area over its base for a height.
WorkingLine parallelDistanceLine(const Out &at) {
  return asked(withNumbers(at.dist == norm(cross(at.w, at.g.v)) / norm(at.g.v)),
               at.closest.which == ClosestPointsCase::Parallel
                   ? words("Parallel lines: how far {h.A} is from {g}, an area over the length of its base.",
                           at.letters)
                   : words("0: {h.A} lies on {g}, as every point of the same line does.", at.letters));
}

WorkingLine distanceLine(const Out &at) {
  if (!at.hasPair)
    return parallelDistanceLine(at);
  const Term reach = dot(at.n, at.w);
  return asked(
      withNumbers(at.dist == norm(reach) / norm(at.n)),
      at.closest.which == ClosestPointsCase::Meet
          ? words("0: the lines meet.")
          : words("How far w reaches along n, without a sign: the distance of the lines."),
      {{norm(reach) / dot(at.n, at.n), words("{answer} is divided by n·n: divide by its root, |n|.")},
       {norm(reach), words("{answer} is |n·w|: divide it by |n|.")},
       {norm(at.w), words("{answer} is the length of w, not how far it reaches along n.")}});
}

std::string volumeWords(const Out &at) {
  if (!at.hasPair)
    return words("0: the directions are multiples of each other, so the box has no base.");
  return at.closest.which == ClosestPointsCase::Meet
             ? words("0: w lies in the plane of both lines, so the box has no height.")
             : words("The volume of the box of {g.v}, {h.v} and w.", at.letters);
}

std::string baseWords(const Out &at) {
  return at.hasPair ? words("The area of its base, the parallelogram of {g.v} and {h.v}.", at.letters)
                    : words("0: {g.v} and {h.v} span no parallelogram.", at.letters);
}

LineTable<Out> lines() {
  return {{"there", &Out::areLines, [](const Out &at) { return withNumbers(at.H == footOf(at.g.A, at.h)); },
           thereWords},
          {"back", &Out::areLines, [](const Out &at) { return withNumbers(at.R == footOf(at.H, at.g)); },
           backWords},
          {"w", always, [](const Out &at) { return withNumbers(at.w == at.h.A - at.g.A); },
           says("From {g.A} to {h.A}.")},
          {"equation-g", &Out::areLines,
           [](const Out &at) {
             return equationLine(at, at.g.v, words("The connection is perpendicular to {g}.", at.letters));
           }},
          {"equation-h", &Out::areLines,
           [](const Out &at) {
             return equationLine(at, at.h.v, words("The connection is perpendicular to {h}.", at.letters));
           }},
          {"det", &Out::areLines, determinantLine},
          {"s", &Out::hasPair, firstStepsLine},
          {"t", &Out::hasPair, secondStepsLine},
          {"F", &Out::hasPair, [](const Out &at) { return withNumbers(at.F == at.g.A + at.s * at.g.v); },
           says("The closest point of {g}.")},
          {"G", &Out::hasPair, [](const Out &at) { return withNumbers(at.G == at.h.A + at.t * at.h.v); },
           says("The closest point of {h}.")},
          {"length", &Out::hasPair, [](const Out &at) { return withNumbers(at.dist == norm(at.G - at.F)); },
           lengthWords},
          {"n", &Out::areLines, normalLine},
          {"distance", &Out::areLines, distanceLine},
          {"volume", &Out::areLines, [](const Out &at) { return withNumbers(at.V == norm(dot(at.n, at.w))); },
           volumeWords},
          {"base", &Out::areLines,
           [](const Out &at) { return withProducts(at.base == root(dot(at.n, at.n))); }, baseWords},
          {"height", &Out::hasPair, [](const Out &at) { return withNumbers(at.dist == at.V / norm(at.n)); },
           says("The volume over the area of the base is the height, and that is the distance.")}};
}

/// A way to a line, with the right angle that it makes there; nothing where it has no length.
void drawWay(Figure &figure, const std::string &id, Role role, const Place &from, const Place &to,
             const Term &direction) {
  if (from == to)
    return;
  figure.add(SegmentMark{{id, role, Subject::Point}, from, to});
  figure.add(RightAngleMark{{id + "/angle", Role::Helper, Subject::Point}, to, from - to, place(direction)});
}

/// The shortest connection, with a right angle at each line.
void drawConnection(Figure &figure, const Out &at, const Place &from, const Place &to) {
  const std::string &id = at.dist->mark;
  figure.add(SegmentMark{drawn(at.dist, Role::Result, Subject::Measure), from, to});
  figure.add(RightAngleMark{{id + "/first", Role::Helper, Subject::Measure}, from, to - from, place(at.g.v)});
  figure.add(RightAngleMark{{id + "/second", Role::Helper, Subject::Measure}, to, from - to, place(at.h.v)});
}

/// A square around a closest point in the plane that is perpendicular to n.
void drawFloor(Figure &figure, const Out &at, const std::string &id, const Place &middle) {
  constexpr double reach = 4; // from its middle to each side, in scene units
  const Place along = unitOf(at.first.direction) * reach;
  const Place across = glm::cross(unitOf(at.closest.normal), along);
  figure.add(PolygonMark{
      {at.mark(id), Role::Ghost, Subject::Plane},
      {middle + along + across, middle - along + across, middle - along - across, middle + along - across}});
}

void drawBox(Figure &figure, const Out &at) {
  const ExactVec3 w = at.second.point - at.first.point;
  addSpannedBox(figure, {at.mark("box"), Role::Ghost, Subject::Neutral}, at.first.point,
                {at.first.direction, at.second.direction, w});
  addParallelogram(figure, {at.mark("base"), Role::Result, Subject::Plane}, at.first.point,
                   at.first.direction, at.second.direction);
}

/// What lines that are not parallel have: one pair of closest points, and n through them.
void drawPair(Figure &figure, const Out &at) {
  constexpr double drawnNormalLength = 5; // only its direction matters here
  const Place F = place(at.F);
  const Place G = place(at.G);
  figure.add(pointOf(at.F, Role::Result, Subject::Measure));
  figure.add(pointOf(at.G, Role::Result, Subject::Measure));
  figure.reaches.push_back({at.in.g.id, F});
  figure.reaches.push_back({at.in.h.id, G});
  addDirection(figure, at.n, F, drawnNormalLength, Role::Derived, Subject::Plane);
  drawFloor(figure, at, "floor-g", F);
  if (at.closest.which == ClosestPointsCase::Skew) {
    drawFloor(figure, at, "floor-h", G); // of lines that meet, it is the same
    drawConnection(figure, at, F, G);
  }
}

/// Of parallel lines: the distance, as the height of the parallelogram of the first direction and w.
void drawStrip(Figure &figure, const Out &at) {
  drawConnection(figure, at, place(at.first.point), place(at.foot));
  addParallelogram(figure, {at.dist->mark + "/strip", Role::Ghost, Subject::Measure}, at.first.point,
                   at.first.direction, at.second.point - at.first.point);
}

Figure draw(const Out &at) {
  Figure figure;
  const Place start = place(at.g.A);
  if (at.first.point != at.second.point)
    figure.add(arrowOf(at.w, start, Role::Derived, Subject::Point));
  if (!at.areLines)
    return figure;
  const Place foot = place(at.foot);
  const Place back = place(at.back);
  drawWay(figure, at.mark("there"), Role::Derived, start, foot, at.h.v);
  drawWay(figure, at.mark("back"), Role::Derived, foot, back, at.g.v);
  figure.add(pointOf(at.H, Role::Derived, Subject::Point));
  figure.add(pointOf(at.R, Role::Derived, Subject::Point));
  figure.reaches = {{at.in.g.id, back}, {at.in.h.id, foot}};
  drawBox(figure, at);
  if (at.hasPair)
    drawPair(figure, at);
  else if (at.closest.which == ClosestPointsCase::Parallel)
    drawStrip(figure, at);
  return figure;
}

/// One line slid along the other's direction, until the closest point is where the other line counts from.
void addSlid(const Out &at, std::vector<SpecialCase> &all) {
  const auto add = [&](const Conditions &when, const Term &point, const std::string &role,
                       const LineObject &line, const ExactVec3 &way) {
    all.push_back({when, words("{A} would be the closest point of its line.", {{"A", plainText(point)}}),
                   role, LineObject{ExactVec3(line.point + way), line.direction}});
  };
  if (at.closest.s != 0) {
    const ExactVec3 way = at.first.direction * at.closest.s;
    add(is("back", "start"), at.g.A, "g", at.first, way);
    add(is("back", "start"), at.g.A, "h", at.second, -way);
  }
  if (at.closest.t != 0) {
    const ExactVec3 way = at.second.direction * at.closest.t;
    add(is("t", "0"), at.h.A, "h", at.second, way);
    add(is("t", "0"), at.h.A, "g", at.first, -way);
  }
}

/// The second line turned about its point, until it is parallel or perpendicular to the first.
void addTurned(const Out &at, std::vector<SpecialCase> &all) {
  const auto parts = projectVector(at.second.direction, at.first.direction);
  if (isZero(parts.projection))
    return; // it is perpendicular already, and would vanish along the first
  all.push_back({is("gh", "0"), words("The lines would be perpendicular."), "h",
                 LineObject{at.second.point, parts.rejection}});
  const bool isOnFirst =
      measurePointLine(at.second.point, at.first.point, at.first.direction).which == PointLineCase::On;
  all.push_back({is("case", isOnFirst ? "coincident" : "parallel"),
                 isOnFirst ? words("{g} and {h} would be the same line.", at.letters)
                           : words("The lines would be parallel."),
                 "h", LineObject{at.second.point, parts.projection}});
}

std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  const auto &[point, direction] = at.second;
  if (at.closest.which == ClosestPointsCase::Skew)
    all.push_back({is("case", "meet"), words("The lines would meet."), "h",
                   LineObject{point - ExactVec3(at.closest.second - at.closest.first), direction}});
  if (at.hasPair) {
    addSlid(at, all);
    addTurned(at, all);
  }
  if (at.closest.which == ClosestPointsCase::Parallel)
    all.push_back({is("case", "coincident"), words("{g} and {h} would be the same line.", at.letters), "h",
                   LineObject{measurePointLine(point, at.first.point, at.first.direction).foot, direction}});
  return all;
}

} // namespace

Construction closest_points() {
  return taught<Out, LineObject, LineObject>(
      {.id = "closest-points",
       .word = "distance",
       .title = [] { return words("distance of the lines, closest points"); },
       .roles = {"g", "h"},
       .makes = {{"F", &Out::hasPair, &Out::F}, {"G", &Out::hasPair, &Out::G}},
       .letters = {"w", "H", "R", "n", "s", "t", "V", "dist"},
       .cases = {"skew", "meet", "parallel", "coincident", "zero-direction"},
       .values = {{named::word("back", {"start", "nearer", "closest"}), &Out::areLines, backValue},
                  {named::number("gh"), &Out::areLines, [](const Out &at) { return dot(at.g.v, at.h.v); }},
                  {named::number("hh"), &Out::areLines, [](const Out &at) { return dot(at.h.v, at.h.v); }},
                  {named::number("nn"), &Out::areLines, [](const Out &at) { return dot(at.n, at.n); }},
                  {named::number("s"), &Out::hasPair, &Out::s},
                  {named::number("t"), &Out::hasPair, &Out::t},
                  {named::number("distance"), &Out::areLines, &Out::dist},
                  {named::number("volume"), &Out::areLines, &Out::V},
                  {named::number("base"), &Out::areLines, &Out::base}},
       .lines = lines(),
       .marks = {"w", "there", "back", "H", "R", "n", "floor-g", "floor-h", "box", "base", "dist", "F", "G"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
