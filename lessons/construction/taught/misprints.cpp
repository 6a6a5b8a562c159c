// What the lecture notes print and what holds, beside each other, for one triangle and one ray. A printed
// line is calculated as it stands there; where it comes to something else than the right one, the learner has
// found a counterexample. (Notes PG 2, 3.5 and 6.2, RP 23 and 28, CG, PL.)
#include "geometry/case_names.h"
#include "geometry/intersect_ray_triangle.h"
#include "geometry/point_plane.h"
#include "lessons/construction/construction.h"
#include "lessons/construction/parts/ray_triangle_cases.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/triangle.h"
#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "lessons/words.h"

#include <algorithm>
#include <array>
#include <optional>

namespace halfspace {
namespace {

struct In : Naming {
  Given<TriangleObject> T;
  Given<RayObject> L;
};

/// Of the distance in PG 3.5: its letters, what the printed formula comes to, and n·(Q − P0).
struct DistanceTerms {
  Term a, b, c;
  Term Qx, Qy, Qz;
  Term printed, f, F;
};

struct Out : Naming, TriangleTerms, RayTerms {
  RayTriangle<Rational> meet;
  Term u, v, n, D;
  DistanceTerms distance;
  Term printedPerp, uPerp; ///< (u×v)×u by the printed rule and by the right one
  Term cosine;
  Term s, t, lambda, I;
  Term facing; ///< a normal on the side that the ray comes from
  Term B;      ///< the foot of the origin

  [[nodiscard]] bool hasPlane() const { return meet.perps.denominator != 0; }
  [[nodiscard]] bool hasAngle() const { return meet.perps.uu != 0 && meet.perps.vv != 0; }
  [[nodiscard]] bool crosses() const { return meet.crosses(); }
};

/// One coordinate of a point or a vector, with a letter of its own and the mark of the whole.
Term coordinateOf(Symbol symbol, const Term &whole, int axis) {
  ExactVec3 unit(0, 0, 0);
  unit[axis] = 1;
  return name(std::move(symbol), Rational(vectorOf(whole)[axis]))
      .marked(whole->mark)
      .standingFor(dot(whole, list({unit.x, unit.y, unit.z})));
}

DistanceTerms distanceTermsOf(const In &in, const Term &Q, const Term &n,
                              const PointPlane<Rational> &measured, const Rational &offset) {
  const ExactVec3 normal = vectorOf(n);
  const ExactVec3 start = vectorOf(Q);
  const Rational printed = offset - normal.x * start.x + normal.y * start.y + normal.z * start.z;
  return {coordinateOf(in.own(letter("a")), n, 0),
          coordinateOf(in.own(letter("b")), n, 1),
          coordinateOf(in.own(letter("c")), n, 2),
          coordinateOf(in.own(letter("Q", "x")), Q, 0),
          coordinateOf(in.own(letter("Q", "y")), Q, 1),
          coordinateOf(in.own(letter("Q", "z")), Q, 2),
          name(in.own(letter("h")), printed),
          name(in.own(letter("f")), measured.f).marked(in.mark("F")),
          name(in.own(letter("F")), measured.foot).marked(in.mark("F"))};
}

/// The cosine of the angle between u and v; 0 where there is none.
Surd cosineOf(const TrianglePerps<Rational> &perps) {
  return perps.uu == 0 || perps.vv == 0 ? Surd() : overRoot(perps.uv, Rational(perps.uu * perps.vv));
}

Out compute(const In &in) {
  const auto &[p0, p1, p2] = in.T.object;
  const auto &[origin, direction] = in.L.object;
  const auto meet = intersectRayTriangle(Ray<Rational>{origin, direction}, Triangle<Rational>{p0, p1, p2});
  const auto &perps = meet.perps;
  const auto plane = planeThrough(p0, perps.normal);
  const Rational offset = dot(perps.normal, p0);
  const bool isFromBehind = dot(perps.normal, direction) > 0;
  const RayTerms L = termsOf(in.L);
  const Term n = name(in.own(vectorLetter("n")), perps.normal).marked(in.mark("n"));
  return {in,
          termsOf(in.T),
          L,
          meet,
          name(in.own(vectorLetter("u")), perps.u).marked(in.mark("u")),
          name(in.own(vectorLetter("v")), perps.v).marked(in.mark("v")),
          n,
          name(in.own(letter("D")), offset),
          distanceTermsOf(in, L.Q, n, measurePointPlane(origin, plane), offset),
          name(in.own(vectorLetter("k")), ExactVec3((perps.v - perps.u) * perps.uv)).marked(in.mark("k")),
          name(in.own(perpLetter("u")), perps.uPerp).marked(in.mark("uperp")),
          applied(word("cos"), name(in.own(letter("θ")), std::nullopt), cosineOf(perps)),
          name(in.own(letter("s")), meet.s),
          name(in.own(letter("t")), meet.tTriangle),
          name(in.own(letter("λ")), meet.plane.t),
          madeName(in, "I", meet.plane.point),
          name(in.own(vectorLetter("N")), isFromBehind ? ExactVec3(-perps.normal) : perps.normal)
              .marked(in.mark("N")),
          name(in.own(letter("B")), measurePointPlane(ExactVec3(0, 0, 0), plane).foot).marked(in.mark("B"))};
}

/// What a printed line claims, and what is so.
struct Claim {
  bool printed;
  bool right;

  [[nodiscard]] bool holds() const { return printed == right; }
};

bool isZeroTerm(const Term &number) { return sign(*numberOf(number)) == 0; }

bool distanceHolds(const Out &at) { return isZeroTerm(at.distance.printed - at.distance.f); }
bool perpHolds(const Out &at) { return vectorOf(at.printedPerp) == vectorOf(at.uPerp); }

/// That the corners lie on one line. Requires an angle.
Claim collinearClaim(const Out &at) { return {isZeroTerm(at.cosine - 1), at.meet.perps.denominator == 0}; }

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

/// The printed lines that say something here, each with whether it holds.
std::vector<std::pair<const char *, bool>> printedLines(const Out &at) {
  std::vector<std::pair<const char *, bool>> all{{"triple", perpHolds(at)}};
  if (at.hasPlane())
    all.emplace_back("distance", distanceHolds(at));
  if (at.hasPlane() && !isZeroTerm(at.D))
    all.emplace_back("direction", directionHolds(at));
  if (at.hasAngle())
    all.emplace_back("cosine", collinearClaim(at).holds());
  if (at.crosses()) {
    all.emplace_back("facing", facingHolds(at));
    all.emplace_back("perimeter", perimeterClaim(at).holds());
    all.emplace_back("vertex", vertexClaim(at).holds());
    all.emplace_back("start", hitClaim(at).holds());
  }
  return all;
}

std::string countWords(const Out &at) {
  const auto all = printedLines(at);
  const auto wrong = std::count_if(all.begin(), all.end(), [](const auto &each) { return !each.second; });
  return wrong == 0 ? words("No printed line is refuted here.")
                    : words("Printed lines refuted here: {count}.", {{"count", std::to_string(wrong)}});
}

CaseWords tell(const In &in, const Out &at) {
  const std::string caseName(nameOf(at.meet.which));
  const WordValues found{{"place", placeWords(at.meet.location, at)},
                         {"lambda", equation(at.lambda)},
                         {"count", countWords(at)}};
  switch (at.meet.which) {
  case RayTriangleCase::Hit:
    return {caseName, words("The ray hits {place}, at {lambda}. {count}", found)};
  case RayTriangleCase::Behind:
    return {caseName,
            words("The triangle is behind the ray: only its line goes through, at {lambda}. {count}", found)};
  case RayTriangleCase::Miss:
    return {caseName, words("The line of the ray meets the plane outside the triangle. {count}", found)};
  case RayTriangleCase::Parallel:
  case RayTriangleCase::InPlane:
    return {caseName, words("{r}·n = 0: the ray and the plane have no single point in common. {count}",
                            at.letters, {{"count", countWords(at)}})};
  case RayTriangleCase::ZeroDirection:
    return zeroDirectionWords(at);
  case RayTriangleCase::Coincident:
    return {caseName, words("{same}: this is no triangle.", {{"same", coincidentWords(in.T.object, at)}}),
            true};
  case RayTriangleCase::Collinear:
    break;
  }
  return {caseName,
          words("{P0}, {P1} and {P2} lie on one line. {count}", at.letters, {{"count", countWords(at)}}),
          true};
}

std::vector<NamedValue> valuesOf(const In &, const Out &at) {
  std::vector<NamedValue> values;
  for (const auto &[name, holds] : printedLines(at))
    values.push_back({name, {}, std::string(holds ? "holds" : "fails")});
  values.push_back(listed("printed_perp", at.printedPerp));
  values.push_back(listed("u_perp", at.uPerp));
  if (at.hasPlane()) {
    values.push_back(listed("printed_f", at.distance.printed));
    values.push_back(listed("f", at.distance.f));
    values.push_back(listed("D", at.D));
  }
  if (at.hasAngle())
    values.push_back(listed("cos_angle", at.cosine));
  if (!at.crosses())
    return values;
  values.push_back({"location", words("place"), std::string(nameOf(at.meet.location.part))});
  if (at.meet.location.feature >= 0)
    values.push_back({"feature", {}, at.meet.location.feature});
  values.push_back(listed("t", at.lambda));
  values.push_back(listed("point", at.I));
  values.push_back(listed("s", at.s));
  values.push_back(listed("t_triangle", at.t));
  values.push_back(listed("denominator", dot(at.r, at.n)));
  return values;
}

std::vector<MadeObject> make(const In &, const Out &at) {
  if (!at.crosses())
    return {};
  return {{"I", PointObject{at.meet.plane.point}}};
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

void addDistanceLines(const Out &at, Explanation &lines) {
  const DistanceTerms &own = at.distance;
  lines.add("normal", [&] {
    return asked(withProducts((at.n == list({own.a, own.b, own.c})) == cross(at.u, at.v)),
                 words("A normal of the triangle's plane, and its three numbers."));
  });
  lines.add("D", [&] {
    return asked(withProducts(at.D == dot(at.n, at.P0)), words("The same for every point of the plane."));
  });
  lines.add("distance-printed", [&] {
    return line(
        withNumbers(own.printed == at.D - own.a * own.Qx + own.b * own.Qy + own.c * own.Qz),
        words("As printed. {verdict}", {{"verdict", comparedWords(own.printed, own.f, distanceHolds(at))}}));
  });
  lines.add("distance-right", [&] {
    return asked(withNumbers((own.f == dot(at.n, at.Q - at.P0)) ==
                             own.a * own.Qx + own.b * own.Qy + own.c * own.Qz - at.D),
                 words("Right. Divided by |n|, it is the signed distance."),
                 {{-own.f, words("{answer} has the wrong sign: it is the printed line D − n·Q, with all its "
                                 "signs.")}});
  });
  lines.add("foot", [&] {
    return asked(withNumbers(own.F == at.Q - own.f / dot(at.n, at.n) * at.n),
                 words("The foot of {Q} in the plane.", at.letters));
  });
}

void addPerpLines(const Out &at, Explanation &lines) {
  lines.add("triple-printed", [&at] {
    return line(withNumbers(at.printedPerp == dot(at.u, at.v) * at.v - dot(at.v, at.u) * at.u),
                words("As printed. {verdict}",
                      {{"verdict", comparedWords(at.printedPerp, at.uPerp, perpHolds(at))}}));
  });
  lines.add("triple-right", [&at] {
    return asked(withNumbers((at.uPerp == cross(cross(at.u, at.v), at.u)) ==
                             dot(at.u, at.u) * at.v - dot(at.v, at.u) * at.u),
                 words("Right: the first bracket has the two outer vectors."));
  });
}

std::string cosineWords(const Out &at) {
  const Claim claim = collinearClaim(at);
  if (!claim.holds())
    return words("It is −1, not 1: by the printed test the corners are not on one line. Refuted: they are.");
  return claim.right ? words("It is 1, and the corners are on one line. Here the printed test is right.")
                     : words("It is not 1, and the corners are not on one line. Here the printed test is "
                             "right.");
}

void addAngleLines(const Out &at, Explanation &lines) {
  lines.add("cosine", [&at] {
    return asked(withNumbers(at.cosine == dot(at.u, at.v) / (norm(at.u) * norm(at.v))), cosineWords(at));
  });
  lines.add("squares", [&at] {
    return line(compared(power(dot(at.u, at.v), 2), dot(at.u, at.u) * dot(at.v, at.v)),
                words("Right: {left} against {right}. They are equal exactly when the corners lie on one "
                      "line, whether the cosine is 1 or −1.",
                      {{"left", plainText(calculated(power(dot(at.u, at.v), 2)))},
                       {"right", plainText(calculated(dot(at.u, at.u) * dot(at.v, at.v)))}}));
  });
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

void addPlaceLines(const Out &at, Explanation &lines) {
  lines.add("lambda", [&at] {
    return asked(withNumbers(at.lambda == dot(at.P0 - at.Q, at.n) / dot(at.r, at.n)), startWords(at),
                 {wrongSignOf(at.lambda, at)});
  });
  lines.add("hit", [&at] {
    return asked(withNumbers(at.I == at.Q + at.lambda * at.r),
                 words("Where the line of the ray goes through the plane."));
  });
  lines.add("s", [&at] {
    return asked(withNumbers(at.s == dot(at.n, cross(at.I - at.P0, at.v)) / dot(at.n, at.n)));
  });
  lines.add("t", [&at] {
    return asked(withNumbers(at.t == dot(at.n, cross(at.u, at.I - at.P0)) / dot(at.n, at.n)));
  });
  lines.add("perimeter", [&at] {
    return line({withResult(at.s), withResult(at.t), withResult(at.s + at.t)}, perimeterWords(at));
  });
  lines.add("vertex", [&at] {
    return line({withResult(1 - at.s - at.t), withResult(at.s), withResult(at.t)}, vertexWords(at));
  });
}

void addNormalLines(const Out &at, Explanation &lines) {
  lines.add("facing", [&at] {
    return asked(withProducts(dot(at.r, at.n)),
                 facingHolds(at)
                     ? words("Negative: n looks towards the ray. The note takes n, and here it is right.")
                     : words("Positive: n looks away from the ray. The note takes n even so. Refuted."));
  });
  lines.add("facing-right", [&at] {
    return asked(withResult(at.facing == (facingHolds(at) ? at.n : -at.n)),
                 facingHolds(at) ? words("Right: n itself.") : words("Right: the opposite of n."));
  });
}

std::string directionWords(const Out &at) {
  if (isZeroTerm(at.D))
    return words("D = 0: the plane goes through O, and there is no way to go.");
  return directionHolds(at)
             ? words("From O to B it is a positive multiple of n. The notes say so, and here it is right.")
             : words("From O to B it is a negative multiple of n: the opposite direction. Refuted.");
}

Explanation explain(const In &, const Out &at) {
  Explanation lines;
  lines.add("u", [&at] { return asked(withNumbers(at.u == at.P1 - at.P0)); });
  lines.add("v", [&at] {
    return asked(withNumbers(at.v == at.P2 - at.P0),
                 words("Two sides of the triangle, both from {P0}.", at.letters));
  });
  if (at.hasPlane())
    addDistanceLines(at, lines);
  addPerpLines(at, lines);
  if (at.hasAngle())
    addAngleLines(at, lines);
  if (at.crosses()) {
    addPlaceLines(at, lines);
    addNormalLines(at, lines);
  }
  if (at.hasPlane())
    lines.add("direction", [&at] {
      return asked(withNumbers(at.B == at.D / dot(at.n, at.n) * at.n), directionWords(at));
    });
  return lines;
}

/// In units of the picture: only the directions matter.
constexpr double drawnNormalLength = 2.5;
constexpr double drawnPerpLength = 3.5;

void drawDirection(Figure &figure, const Term &vector, const Place &from, double length, Role role,
                   Subject subject) {
  if (const ExactVec3 direction = vectorOf(vector); !isZero(direction))
    figure.add(arrowOfLength(drawn(vector, role, subject), from, direction, length));
}

/// The line through two corners, on which one of s, t and s + t stays the same.
void drawEdgeLine(Figure &figure, std::string id, const ExactVec3 &from, const ExactVec3 &to) {
  if (from != to)
    figure.add(
        LineMark{{std::move(id), Role::Helper, Subject::Triangle}, place(from), place(ExactVec3(to - from))});
}

void drawPlane(Figure &figure, const In &in, const Out &at) {
  const Place origin(0);
  drawDirection(figure, at.n, place(at.P0), drawnNormalLength, Role::Derived, Subject::Plane);
  const Place foot = place(at.distance.F);
  figure.add(pointOf(at.distance.F, Role::Derived, Subject::Measure));
  figure.add(SegmentMark{{in.mark("F/distance"), Role::Helper, Subject::Measure}, foot, place(at.Q)});
  figure.add(PointMark{{in.mark("B/origin"), Role::Helper, Subject::Neutral, "O"}, origin});
  figure.add(pointOf(at.B, Role::Derived, Subject::Plane));
  figure.add(SegmentMark{{in.mark("B/way"), Role::Helper, Subject::Plane}, origin, place(at.B)});
}

void drawMeeting(Figure &figure, const In &in, const Out &at) {
  const Place point = place(at.I);
  const auto &[p0, p1, p2] = in.T.object;
  drawEdgeLine(figure, in.mark("edges"), p0, p1);
  drawEdgeLine(figure, in.mark("edges/second"), p1, p2);
  drawEdgeLine(figure, in.mark("edges/third"), p2, p0);
  drawDirection(figure, at.facing, point, drawnNormalLength, Role::Result, Subject::Plane);
  if (at.meet.plane.t >= 0)
    figure.reaches.push_back({in.L.id, point});
  else
    figure.add(SegmentMark{{at.I->mark + "/backward", Role::Ghost, Subject::Ray}, place(at.Q), point});
  const bool isHit = at.meet.which == RayTriangleCase::Hit;
  figure.add(pointOf(at.I, isHit ? Role::Result : Role::Ghost, Subject::Ray));
}

Figure draw(const In &in, const Out &at) {
  Figure figure;
  const Place p0 = place(at.P0);
  figure.add(arrowOf(at.u, p0, Role::Given, Subject::EdgeU));
  figure.add(arrowOf(at.v, p0, Role::Given, Subject::EdgeV));
  drawDirection(figure, at.uPerp, p0, drawnPerpLength, Role::Derived, Subject::EdgeU);
  drawDirection(figure, at.printedPerp, p0, drawnPerpLength, Role::Warning, Subject::Neutral);
  if (at.hasPlane())
    drawPlane(figure, in, at);
  if (at.crosses())
    drawMeeting(figure, in, at);
  return figure;
}

std::vector<SpecialCase> nearby(const In &in, const Out &at) {
  auto all = rayTriangleNearby(in.T.object, in.L.object, at, at);
  const auto &[p0, p1, p2] = in.T.object;
  if (at.hasPlane())
    all.push_back({"cosine = fails", words("{P0} would lie between {P1} and {P2}.", at.letters), "T",
                   TriangleObject{(p1 + p2) / Rational(2), p1, p2}});
  return all;
}

ValueName verdict(const char *name) { return named::word(name, {"holds", "fails"}); }

} // namespace

Construction misprints() {
  return makeConstruction<In, Out, TriangleObject, RayObject>(
      "misprints", {"T", "L"}, {{"I", "point"}},
      {"u", "v", "n", "D", "a", "b", "c", "Qx", "Qy", "Qz", "h", "f", "F", "k", "θ", "s", "t", "λ", "N", "B"},
      {.cases = {"hit", "behind", "miss", "parallel", "in-plane", "zero-direction", "coincident",
                 "collinear"},
       .values = {verdict("distance"),
                  verdict("triple"),
                  verdict("cosine"),
                  verdict("perimeter"),
                  verdict("vertex"),
                  verdict("facing"),
                  verdict("direction"),
                  verdict("start"),
                  named::vector("printed_perp"),
                  named::vector("u_perp"),
                  named::number("printed_f"),
                  named::number("f"),
                  named::number("D"),
                  named::number("cos_angle"),
                  named::word("location", {"interior", "edge", "vertex", "outside"}),
                  named::index("feature"),
                  named::number("t"),
                  named::vector("point"),
                  named::number("s"),
                  named::number("t_triangle"),
                  named::number("denominator")},
       .lines = {"u",
                 "v",
                 "normal",
                 "D",
                 "distance-printed",
                 "distance-right",
                 "foot",
                 "triple-printed",
                 "triple-right",
                 "cosine",
                 "squares",
                 "lambda",
                 "hit",
                 "s",
                 "t",
                 "perimeter",
                 "vertex",
                 "facing",
                 "facing-right",
                 "direction"},
       .marks = {"u", "v", "n", "uperp", "k", "F", "B", "edges", "N", "I"}},
      {compute, tell, valuesOf, make, explain, draw, nearby});
}

} // namespace halfspace
