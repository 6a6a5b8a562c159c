// What the lecture notes print and what holds, beside each other, for one triangle and one ray. A printed
// line is calculated as it stands there; where it comes to something else than the right one, the learner has
// found a counterexample. (Notes PG 2, 3.5 and 6.2, RP 23 and 28, CG, PL.)
//
// Long because each of the misprints has a claim that is tried, words for either outcome, and lines of its
// own.
#include "geometry/case_names.h"
#include "geometry/intersect_ray_triangle.h"
#include "geometry/point_plane.h"
#include "lessons/construction/parts/ray_marks.h"
#include "lessons/construction/parts/ray_triangle_cases.h"
#include "lessons/construction/parts/value_words.h"
#include "lessons/construction/taught.h"

#include <algorithm>
#include <array>

namespace halfspace {
namespace {

/// One coordinate of a point or a vector, with a letter of its own and the mark of the whole.
Term coordinateOf(Symbol symbol, const Term &whole, int axis) {
  ExactVec3 unit(0, 0, 0);
  unit[axis] = 1;
  return name(std::move(symbol), Rational(vectorOf(whole)[axis]))
      .marked(whole->mark)
      .standingFor(dot(whole, list({unit.x, unit.y, unit.z})));
}

/// D − n·Q with its signs as they are printed.
Rational printedDistance(const Plane<Rational> &plane, const ExactVec3 &start) {
  const auto &[normal, offset] = plane;
  return -offset - normal.x * start.x + normal.y * start.y + normal.z * start.z;
}

struct Out : RayByPerps {
  using RayByPerps::RayByPerps;

  Plane<Rational> plane = planeThrough(triangle.p0, perps.normal);
  PointPlane<Rational> measured = measurePointPlane(ray.origin, plane);
  bool hasAngle = perps.uu != 0 && perps.vv != 0;

  Term D = ownName(letter("D"), Rational(-plane.offset));
  // Of the distance in PG 3.5: its letters, what the printed formula comes to, and n·(Q − P0).
  Term a = coordinateOf(own(letter("a")), n, 0);
  Term b = coordinateOf(own(letter("b")), n, 1);
  Term c = coordinateOf(own(letter("c")), n, 2);
  Term Qx = coordinateOf(own(letter("Q", "x")), Q, 0);
  Term Qy = coordinateOf(own(letter("Q", "y")), Q, 1);
  Term Qz = coordinateOf(own(letter("Q", "z")), Q, 2);
  Term h = ownName(letter("h"), printedDistance(plane, ray.origin));
  Term f = ownName(letter("f"), measured.f).marked(mark("F"));
  Term F = drawnName(letter("F"), measured.foot);
  // (u×v)×u by the printed rule and by the right one.
  Term printedPerp = drawnName(vectorLetter("k"), ExactVec3((perps.v - perps.u) * perps.uv));
  Term cosine = applied(word("cos"), ownName(letter("θ"), std::nullopt), cosineOf(perps));
  /// A normal on the side that the ray comes from.
  Term facing = drawnName(vectorLetter("N"),
                          dot(perps.normal, ray.direction) > 0 ? ExactVec3(-perps.normal) : perps.normal);
  Term B = drawnName(letter("B"), measurePointPlane(ExactVec3(0), plane).foot); ///< the foot of the origin
};

/// What a printed line claims, and what is so.
struct Claim {
  bool printed;
  bool right;

  [[nodiscard]] bool holds() const { return printed == right; }
};

bool isZeroTerm(const Term &number) { return sign(*numberOf(number)) == 0; }

bool distanceHolds(const Out &at) { return isZeroTerm(at.h - at.f); }
bool perpHolds(const Out &at) { return vectorOf(at.printedPerp) == vectorOf(at.uPerp); }

/// That the corners lie on one line. Requires an angle.
Claim collinearClaim(const Out &at) { return {isZeroTerm(at.cosine - 1), at.perps.denominator == 0}; }

/// That I is on the perimeter. This and the next require a point.
Claim perimeterClaim(const Out &at) {
  const auto &[s, t] = std::pair(at.meet.s, at.meet.tTriangle);
  return {s == 0 || t == 0 || s + t == 1,
          at.meet.location.part == FacePart::Edge || at.meet.location.part == FacePart::Vertex};
}

/// That I is a corner: printed is that one of the parameters is between 0 and 1, and the others are 0.
Claim vertexClaim(const Out &at) {
  const std::array parameters{Rational(1 - at.meet.s - at.meet.tTriangle), at.meet.s, at.meet.tTriangle};
  const auto between = [](const Rational &each) { return each > 0 && each < 1; };
  return {std::count(parameters.begin(), parameters.end(), Rational(0)) == 2 &&
              std::any_of(parameters.begin(), parameters.end(), between),
          at.meet.location.part == FacePart::Vertex};
}

/// That the ray hits.
Claim hitClaim(const Out &at) {
  return {at.meet.location.part != FacePart::Outside, at.meet.which == RayTriangleCase::Hit};
}

bool facingHolds(const Out &at) { return sign(*numberOf(dot(at.r, at.n))) == -1; }
bool directionHolds(const Out &at) { return sign(*numberOf(at.D)) == 1; }

/// A printed line that says something in some cases, and whether it holds there.
struct Verdict {
  const char *name;
  When<Out> speaks;
  When<Out> holds;
};

std::vector<Verdict> verdicts() {
  return {{"triple", always, perpHolds},
          {"distance", &Out::isTriangle, distanceHolds},
          {"direction", [](const Out &at) { return at.isTriangle && !isZeroTerm(at.D); }, directionHolds},
          {"cosine", &Out::hasAngle, [](const Out &at) { return collinearClaim(at).holds(); }},
          {"facing", &Out::crosses, facingHolds},
          {"perimeter", &Out::crosses, [](const Out &at) { return perimeterClaim(at).holds(); }},
          {"vertex", &Out::crosses, [](const Out &at) { return vertexClaim(at).holds(); }},
          {"start", &Out::crosses, [](const Out &at) { return hitClaim(at).holds(); }}};
}

std::string countWords(const Out &at) {
  const auto refuted = [&](const Verdict &each) { return each.speaks(at) && !each.holds(at); };
  const auto all = verdicts();
  const auto wrong = std::count_if(all.begin(), all.end(), refuted);
  return wrong == 0 ? words("No printed line is refuted here.")
                    : words("Printed lines refuted here: {count}.", {{"count", std::to_string(wrong)}});
}

CaseWords tell(const Out &at) {
  const std::string caseName(nameOf(at.meet.which));
  const WordValues found{{"lambda", equation(at.lambda)}, {"count", countWords(at)}};
  switch (at.meet.which) {
  case RayTriangleCase::Hit:
    return {caseName, placeWords(at.meet.location, at,
                                 {says("The ray hits inside the triangle, at {lambda}. {count}"),
                                  says("The ray hits on the edge {edge}, at {lambda}. {count}"),
                                  says("The ray hits at the corner {corner}, at {lambda}. {count}")},
                                 found)};
  case RayTriangleCase::Behind:
    return {caseName,
            words("The triangle is behind the ray: only its line goes through, at {lambda}. {count}", found)};
  case RayTriangleCase::Miss:
    return {caseName, words("The line of the ray meets the plane outside the triangle. {count}", found)};
  case RayTriangleCase::Parallel:
  case RayTriangleCase::InPlane:
    return {caseName, words("{r}·n = 0: the ray is parallel to the plane, or lies in it. {count}", at.letters,
                            {{"count", countWords(at)}})};
  case RayTriangleCase::ZeroDirection:
    return zeroDirectionWords(at);
  case RayTriangleCase::Coincident:
    return {caseName,
            coincidentWords(at.in.T.object, at,
                            {says("{first} and {second} are the same point: this is no triangle."),
                             says("{first}, {second} and {third} are the same point: this is no triangle.")}),
            true};
  case RayTriangleCase::Collinear:
    break;
  }
  return {caseName,
          words("{P0}, {P1} and {P2} lie on one line. {count}", at.letters, {{"count", countWords(at)}}),
          true};
}

/// Of two terms that come to exact numbers or vectors; without numbers where those would be rounded.
std::string comparedWords(const Term &printed, const Term &right, bool areSame) {
  if (showsRounded(calculated(printed)) || showsRounded(calculated(right)))
    return areSame ? words("Here it comes to the right result. That proves nothing.")
                   : words("Refuted: the two results differ.");
  const WordValues values{{"printed", plainText(calculated(printed))},
                          {"right", plainText(calculated(right))}};
  return areSame ? words("Here it comes to the right result, {right}. That proves nothing.", values)
                 : words("Refuted: {printed} ≠ {right}.", values);
}

std::string cosineWords(const Out &at) {
  const Claim claim = collinearClaim(at);
  if (!claim.holds())
    return words("It is −1, not 1: by the printed test the corners are not on one line. Refuted: they are.");
  return claim.right ? words("It is 1, and the corners are on one line. Here the printed test is right.")
                     : words("It is not 1, and the corners are not on one line. Here the printed test is "
                             "right.");
}

std::string perimeterWords(const Out &at) {
  const Claim claim = perimeterClaim(at);
  if (!claim.holds())
    return words("One of the three conditions holds, so the note says: on the perimeter. Refuted: {I} is on "
                 "the line of an edge, but outside the triangle.",
                 at.letters);
  return claim.right
             ? words("At least one of the three conditions holds, and {I} is on the perimeter. Here the note "
                     "is right.",
                     at.letters)
             : words("None of the three conditions holds, and {I} is not on the perimeter. Here the note is "
                     "right.",
                     at.letters);
}

std::string vertexWords(const Out &at) {
  if (!vertexClaim(at).holds())
    return words("Two are 0, and the third is 1. The note asks for a number between 0 and 1, and finds no "
                 "corner. Refuted: {I} is one.",
                 at.letters);
  return words("{I} is no corner, and the note finds none. Here it is right.", at.letters);
}

std::string startWords(const Out &at) {
  const Claim claim = hitClaim(at);
  if (!claim.holds())
    return words(
        "The note does not look at it and says: hit. Refuted: it is negative, and the ray leads away "
        "from the triangle.");
  return claim.right ? words("Not negative: the ray gets there. Here it does no harm that the note does not "
                             "look at it.")
                     : words("The line passes outside the triangle anyway. Here the note is right.");
}

std::string directionWords(const Out &at) {
  if (isZeroTerm(at.D))
    return words("D = 0: the plane goes through O, and the distance is 0.");
  return directionHolds(at)
             ? words("From O to B it is a positive multiple of n. The notes say so, and here it is right.")
             : words("From O to B it is a negative multiple of n: the opposite direction. Refuted.");
}

Chain printedDistanceOf(const Out &at) {
  return withNumbers(at.h == at.D - at.a * at.Qx + at.b * at.Qy + at.c * at.Qz);
}

WorkingLine distanceLine(const Out &at) {
  return asked(
      withNumbers((at.f == dot(at.n, at.Q - at.P0)) == at.a * at.Qx + at.b * at.Qy + at.c * at.Qz - at.D),
      words("Right. Divided by |n|, it is the signed distance."),
      {{-at.f, words("{answer} has the wrong sign: it is D − n·Q.")}});
}

/// A line of the notes, and whether it comes to the right result.
WorkingLine printedLine(const Chain &chain, const Term &printed, const Term &right, bool holds) {
  return line(chain, words("As printed. {verdict}", {{"verdict", comparedWords(printed, right, holds)}}));
}

WorkingLine squaresLine(const Out &at) {
  const Term square = power(dot(at.u, at.v), 2);
  const Term squares = dot(at.u, at.u) * dot(at.v, at.v);
  return line(compared(square, squares),
              words("Right: {left} against {right}. They are equal exactly when the corners lie on one "
                    "line, whether the cosine is 1 or −1.",
                    {{"left", plainText(calculated(square))}, {"right", plainText(calculated(squares))}}));
}

WorkingLine parameterLine(const Out &at) {
  return asked(withNumbers(at.lambda == dot(at.P0 - at.Q, at.n) / dot(at.r, at.n)), startWords(at),
               {wrongSignOf(at.lambda, at)});
}

std::string facingWords(const Out &at) {
  return facingHolds(at)
             ? words("Negative: the line of the ray comes from the side to which n points. The note takes n, "
                     "and here it is right.")
             : words("Positive: the line of the ray goes to the side to which n points. The note takes n "
                     "even so. Refuted.");
}

WorkingLine facingLine(const Out &at) {
  return facingHolds(at) ? asked(withResult(at.facing == at.n), words("Right: n itself."))
                         : asked(withResult(at.facing == -at.n), words("Right: the opposite of n."));
}

LineTable<Out> lines() {
  return joined<LineRow<Out>>(
      {sideLines<Out>(),
       {{"normal", &Out::isTriangle,
         [](const Out &at) {
           return withProducts((at.n == list({at.a, at.b, at.c})) == cross(at.u, at.v));
         },
         says("A normal of the triangle's plane, and its three numbers.")},
        {"D", &Out::isTriangle, [](const Out &at) { return withProducts(at.D == dot(at.n, at.P0)); },
         says("The same for every point of the plane.")},
        {"distance-printed", &Out::isTriangle,
         [](const Out &at) { return printedLine(printedDistanceOf(at), at.h, at.f, distanceHolds(at)); }},
        {"distance-right", &Out::isTriangle, distanceLine},
        {"foot", &Out::isTriangle,
         [](const Out &at) { return withNumbers(at.F == at.Q - at.f / dot(at.n, at.n) * at.n); },
         says("The foot of {Q} in the plane.")},
        {"triple-printed", always,
         [](const Out &at) {
           return printedLine(withNumbers(at.printedPerp == dot(at.u, at.v) * at.v - dot(at.v, at.u) * at.u),
                              at.printedPerp, at.uPerp, perpHolds(at));
         }},
        {"triple-right", always,
         [](const Out &at) {
           return withNumbers((at.uPerp == cross(cross(at.u, at.v), at.u)) ==
                              dot(at.u, at.u) * at.v - dot(at.v, at.u) * at.u);
         },
         says("Right: the first bracket has the two outer vectors.")},
        {"cosine", &Out::hasAngle,
         [](const Out &at) { return withNumbers(at.cosine == dot(at.u, at.v) / (norm(at.u) * norm(at.v))); },
         cosineWords},
        {"squares", &Out::hasAngle, squaresLine},
        {"lambda", &Out::crosses, parameterLine},
        {"hit", &Out::crosses, [](const Out &at) { return withNumbers(at.I == at.Q + at.lambda * at.r); },
         says("Where the line of the ray goes through the plane.")},
        {"s", &Out::crosses,
         [](const Out &at) {
           return asked(withNumbers(at.s == dot(at.n, cross(at.I - at.P0, at.v)) / dot(at.n, at.n)));
         }},
        {"t", &Out::crosses,
         [](const Out &at) {
           return asked(withNumbers(at.t == dot(at.n, cross(at.u, at.I - at.P0)) / dot(at.n, at.n)));
         }},
        {"perimeter", &Out::crosses,
         [](const Out &at) {
           return resultsLine({at.s, at.t, at.s + at.t}, perimeterWords(at));
         }},
        {"vertex", &Out::crosses,
         [](const Out &at) {
           return resultsLine({1 - at.s - at.t, at.s, at.t}, vertexWords(at));
         }},
        {"facing", &Out::crosses, [](const Out &at) { return withProducts(dot(at.r, at.n)); }, facingWords},
        {"facing-right", &Out::crosses, facingLine},
        {"direction", &Out::isTriangle,
         [](const Out &at) { return withNumbers(at.B == at.D / dot(at.n, at.n) * at.n); }, directionWords}}});
}

/// In units of the picture: only the directions matter.
constexpr double drawnNormalLength = 2.5;
constexpr double drawnPerpLength = 3.5;

/// The line through two corners, on which one of s, t and s + t stays the same.
void drawEdgeLine(Figure &figure, std::string id, const ExactVec3 &from, const ExactVec3 &to) {
  if (from != to)
    figure.add(
        LineMark{{std::move(id), Role::Helper, Subject::Triangle}, place(from), place(ExactVec3(to - from))});
}

void drawPlane(Figure &figure, const Out &at) {
  const Place origin(0);
  addDirection(figure, at.n, place(at.P0), drawnNormalLength, Role::Derived, Subject::Plane);
  const Place foot = place(at.F);
  figure.add(pointOf(at.F, Role::Derived, Subject::Measure));
  figure.add(SegmentMark{{at.mark("F/distance"), Role::Helper, Subject::Measure}, foot, place(at.Q)});
  figure.add(
      pointOf(name(letter("O"), ExactVec3(0)).marked(at.mark("B/origin")), Role::Helper, Subject::Neutral));
  figure.add(pointOf(at.B, Role::Derived, Subject::Plane));
  figure.add(SegmentMark{{at.mark("B/way"), Role::Helper, Subject::Plane}, origin, place(at.B)});
}

void drawMeeting(Figure &figure, const Out &at) {
  const Place point = place(at.I);
  const auto &[p0, p1, p2] = at.in.T.object;
  drawEdgeLine(figure, at.mark("edges"), p0, p1);
  drawEdgeLine(figure, at.mark("edges/second"), p1, p2);
  drawEdgeLine(figure, at.mark("edges/third"), p2, p0);
  addDirection(figure, at.facing, point, drawnNormalLength, Role::Result, Subject::Plane);
  addMeeting(figure, at.in.L, at.I, at.meet.plane.t >= 0, at.meet.which == RayTriangleCase::Hit);
}

Figure draw(const Out &at) {
  Figure figure;
  const Place p0 = place(at.P0);
  figure.add(arrowOf(at.u, p0, Role::Given, Subject::EdgeU));
  figure.add(arrowOf(at.v, p0, Role::Given, Subject::EdgeV));
  addDirection(figure, at.uPerp, p0, drawnPerpLength, Role::Derived, Subject::EdgeU);
  addDirection(figure, at.printedPerp, p0, drawnPerpLength, Role::Warning, Subject::Neutral);
  if (at.isTriangle)
    drawPlane(figure, at);
  if (at.crosses)
    drawMeeting(figure, at);
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  auto all = rayTriangleNearby(at);
  const auto &[p0, p1, p2] = at.in.T.object;
  if (at.isTriangle)
    all.push_back({is("cosine", "fails"), words("{P0} would lie between {P1} and {P2}.", at.letters), "T",
                   TriangleObject{(p1 + p2) / Rational(2), p1, p2}});
  return all;
}

ValueTable<Out> verdictRows() {
  ValueTable<Out> rows;
  for (const Verdict &each : verdicts())
    rows.push_back(
        {named::word(each.name, {"holds", "fails"}), each.speaks, [each](const Out &at) {
           return Value(each.holds(at) ? Word{"holds", words("holds")} : Word{"fails", words("fails")});
         }});
  return rows;
}

} // namespace

Construction misprints() {
  return taught<Out, TriangleObject, RayObject>(
      {.id = "misprints",
       .title = [] { return words("misprints in lecture notes"); },
       .roles = {"T", "L"},
       .makes = {{"I", &Out::crosses, &Out::I}},
       .letters = {"u", "v", "n", "D", "a", "b", "c", "Qx", "Qy", "Qz",
                   "h", "f", "F", "k", "θ", "s", "t", "λ",  "N",  "B"},
       .cases = {"hit", "behind", "miss", "parallel", "in-plane", "zero-direction", "coincident",
                 "collinear"},
       .values = joined<ValueRow<Out>>(
           {verdictRows(),
            {{named::vector("printed_perp"), always, &Out::printedPerp},
             {named::vector("u_perp"), always, &Out::uPerp},
             {named::number("printed_f"), &Out::isTriangle, &Out::h},
             {named::number("f"), &Out::isTriangle, &Out::f},
             {named::number("D"), &Out::isTriangle, &Out::D},
             {named::number("cos_angle"), &Out::hasAngle, &Out::cosine}},
            crossingRows<Out>([](const Out &at) { return at.meet.location; }),
            shareRows<Out>(),
            {{named::number("denominator"), &Out::crosses, [](const Out &at) { return dot(at.r, at.n); }}}}),
       .lines = lines(),
       .marks = {"u", "v", "n", "uperp", "k", "F", "B", "edges", "N", "I"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
