// Where a ray meets a triangle, by u⊥ and v⊥ with five dot products (note PG 6.2, figure 4). The ray's
// parameter is λ here, because s and t belong to the triangle.
#include "geometry/case_names.h"
#include "geometry/intersect_ray_triangle.h"
#include "geometry/point_line.h"
#include "lessons/construction/construction.h"
#include "lessons/construction/parts/ray_triangle_cases.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/construction/parts/zero_vectors.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/triangle.h"
#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "lessons/words.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <tuple>

namespace halfspace {
namespace {

struct In : Naming {
  Given<TriangleObject> T;
  Given<RayObject> L;
};

struct Out : Naming, TriangleTerms, RayTerms {
  RayTriangle<Rational> meet;
  Term u, v, n, uPerp, vPerp, D;
  Term lambda, I, w, s, t;
  Term a, b;    ///< w·u⊥ and v·u⊥
  Term A, B, C; ///< figure 4: the feet of C and P2 on u⊥, and C at the tip of t·v
};

/// Of a point on the line through another; the origin for a zero direction, where no line is.
ExactVec3 footOf(const ExactVec3 &point, const ExactVec3 &through, const ExactVec3 &direction) {
  return measurePointLine(point, through, direction).foot;
}

Out compute(const In &in) {
  const auto &[p0, p1, p2] = in.T.object;
  const auto &[origin, direction] = in.L.object;
  const auto meet = intersectRayTriangle(Ray<Rational>{origin, direction}, Triangle<Rational>{p0, p1, p2});
  const auto &perps = meet.perps;
  const ExactVec3 tipOfTv = p0 + perps.v * meet.tTriangle;
  return {in,
          termsOf(in.T),
          termsOf(in.L),
          meet,
          name(in.own(vectorLetter("u")), perps.u).marked(in.mark("u")),
          name(in.own(vectorLetter("v")), perps.v).marked(in.mark("v")),
          name(in.own(vectorLetter("n")), perps.normal).marked(in.mark("n")),
          name(in.own(perpLetter("u")), perps.uPerp).marked(in.mark("uperp")),
          name(in.own(perpLetter("v")), perps.vPerp).marked(in.mark("vperp")),
          name(in.own(letter("D")), perps.denominator),
          name(in.own(letter("λ")), meet.plane.t),
          madeName(in, "I", meet.plane.point),
          name(in.own(vectorLetter("w")), meet.w).marked(in.mark("w")),
          name(in.own(letter("s")), meet.s),
          name(in.own(letter("t")), meet.tTriangle),
          name(in.own(letter("a")), dot(meet.w, perps.uPerp)).marked(in.mark("A")),
          name(in.own(letter("b")), dot(perps.v, perps.uPerp)).marked(in.mark("B")),
          name(in.own(letter("A")), footOf(tipOfTv, p0, perps.uPerp)).marked(in.mark("A")),
          name(in.own(letter("B")), footOf(p2, p0, perps.uPerp)).marked(in.mark("B")),
          name(in.own(letter("C")), tipOfTv).marked(in.mark("C"))};
}

CaseWords tell(const In &in, const Out &at) {
  const std::string lambda = equation(at.lambda);
  const std::string caseName(nameOf(at.meet.which));
  switch (at.meet.which) {
  case RayTriangleCase::Hit:
    return {caseName, words("The ray hits {place}, at {lambda}.",
                            {{"place", placeWords(at.meet.location, at)}, {"lambda", lambda}})};
  case RayTriangleCase::Behind:
    return {caseName, words("{lambda} is negative: the triangle is behind the ray's start. The line "
                            "backwards would meet it {place}.",
                            {{"place", placeWords(at.meet.location, at)}, {"lambda", lambda}})};
  case RayTriangleCase::Miss:
    return {caseName, words("The line meets the triangle's plane outside the triangle: {s}, {t}, {sum}.",
                            {{"s", equation(at.s)}, {"t", equation(at.t)}, {"sum", equation(at.s + at.t)}})};
  case RayTriangleCase::Parallel:
    return {caseName, words("{r}·n = 0: the ray runs parallel to the triangle's plane and never meets it.",
                            at.letters)};
  case RayTriangleCase::InPlane:
    return {caseName, words("{r}·n = 0 and {Q} lies in the triangle's plane: the ray runs inside it, and no "
                            "single point is the hit.",
                            at.letters)};
  case RayTriangleCase::ZeroDirection:
    return zeroDirectionWords(at);
  case RayTriangleCase::Coincident:
    return {caseName,
            words("{same}: this is no triangle, and the denominator is 0.",
                  {{"same", coincidentWords(in.T.object, at)}}),
            true};
  case RayTriangleCase::Collinear:
    break;
  }
  return {caseName,
          words("{P0}, {P1} and {P2} lie on one line: (u·v)² equals (u·u)(v·v), so the denominator is 0 and "
                "there is no triangle to hit.",
                at.letters),
          true};
}

std::vector<NamedValue> perpValues(const Out &at) {
  std::vector<NamedValue> values{listed("u_perp", at.uPerp), listed("v_perp", at.vPerp),
                                 listed("uu", dot(at.u, at.u)), listed("uv", dot(at.u, at.v)),
                                 listed("vv", dot(at.v, at.v))};
  if (at.meet.crosses()) {
    values.push_back(listed("wu", dot(at.w, at.u)));
    values.push_back(listed("wv", dot(at.w, at.v)));
  }
  values.push_back(listed("denominator", at.D));
  return values;
}

std::vector<NamedValue> valuesOf(const In &, const Out &at) {
  std::vector<NamedValue> values;
  if (at.meet.crosses()) {
    values.push_back({"location", words("place"), std::string(nameOf(at.meet.location.part))});
    if (at.meet.location.feature >= 0)
      values.push_back({"feature", {}, at.meet.location.feature});
    values.push_back(listed("t", at.lambda));
    values.push_back(listed("point", at.I));
    values.push_back(listed("s", at.s));
    values.push_back(listed("t_triangle", at.t));
    values.push_back(listed("barycentric", list({1 - at.s - at.t, at.s, at.t})));
  }
  values.push_back({"perp", {}, perpValues(at)});
  return values;
}

std::vector<MadeObject> make(const In &, const Out &at) {
  if (!at.meet.crosses())
    return {};
  return {{"I", PointObject{at.meet.plane.point}}};
}

void addSideLines(const Out &at, Explanation &lines) {
  const auto &u = at.u;
  const auto &v = at.v;
  lines.add("u", [&] { return asked(withNumbers(u == at.P1 - at.P0)); });
  lines.add("v", [&] {
    return asked(withNumbers(v == at.P2 - at.P0),
                 words("Two sides of the triangle, both from {P0}.", at.letters));
  });
  lines.add("normal", [&] {
    return asked(withProducts(at.n == cross(u, v)), crossProductWords(at.n),
                 {{cross(v, u), words("{answer} is the cross product the other way round: v × u.")}});
  });
  lines.add("uu", [&] { return asked(withProducts(dot(u, u))); });
  lines.add("uv", [&] { return asked(withProducts(dot(u, v))); });
  lines.add("vv", [&] {
    return asked(withProducts(dot(v, v)),
                 words("Three of the five dot products: they belong to the triangle alone."));
  });
  lines.add("uperp", [&] {
    return asked(withNumbers((at.uPerp == cross(at.n, u)) == dot(u, u) * v - dot(u, v) * u),
                 perpWords(at.uPerp, words("u perp: in the plane of the triangle and perpendicular to u.")));
  });
  lines.add("vperp", [&] {
    return asked(withNumbers((at.vPerp == cross(at.n, v)) == dot(u, v) * v - dot(v, v) * u),
                 perpWords(at.vPerp, words("v perp likewise: perpendicular to v.")));
  });
}

WorkingLine denominatorLine(const Out &at) {
  const auto &u = at.u;
  const auto &v = at.v;
  return asked(withNumbers(at.D == power(dot(u, v), 2) - dot(u, u) * dot(v, v)),
               at.meet.perps.denominator == 0
                   ? words("Zero: u and v do not span a triangle, and there is nothing to divide by.")
                   : words("The denominator of s and t. It is zero only for a degenerate triangle."),
               {{-at.D, words("{answer} has the wrong sign: (u·v)² is never the larger part.")}});
}

/// How the ray's line meets the triangle's plane.
void addPlaneLines(const Out &at, Explanation &lines) {
  lines.add("plane-t", [&] {
    return asked(withNumbers(at.lambda == dot(at.P0 - at.Q, at.n) / dot(at.r, at.n)),
                 words("First the triangle's plane: so many steps {r} lead from {Q} to it.", at.letters),
                 {wrongSignOf(at.lambda, at)});
  });
  lines.add("hit", [&] {
    return asked(withNumbers(at.I == at.Q + at.lambda * at.r),
                 words("The point of the plane that the ray's line goes through. Is it in the triangle?"));
  });
  lines.add("w",
            [&] { return asked(withNumbers(at.w == at.I - at.P0), words("From {P0} to {I}.", at.letters)); });
  lines.add("wu", [&] { return asked(withProducts(dot(at.w, at.u))); });
  lines.add("wv", [&] {
    return asked(withProducts(dot(at.w, at.v)), words("The last two of the five dot products."));
  });
}

/// The mistake of a share: the sign of D.
WrongTerm wrongSignOfShare(const Term &share) {
  return {-share, words("{answer} has the wrong sign: the denominator D = (u·v)² − (u·u)(v·v) is negative.")};
}

WorkingLine lineOfS(const Out &at) {
  const auto &[u, v, w] = std::tie(at.u, at.v, at.w);
  return asked(withNumbers((at.s == dot(w, at.vPerp) / dot(u, at.vPerp)) ==
                           (dot(u, v) * dot(w, v) - dot(v, v) * dot(w, u)) / at.D),
               words("Dotted with v⊥, the part t·v drops out and only s is left."),
               {{at.t, words("{answer} is t: for s, w is dotted with v⊥.")}, wrongSignOfShare(at.s)});
}

WorkingLine lineOfT(const Out &at) {
  const auto &[u, v, w] = std::tie(at.u, at.v, at.w);
  return asked(
      withNumbers((at.t == dot(w, at.uPerp) / dot(v, at.uPerp)) ==
                  (dot(u, v) * dot(w, u) - dot(u, u) * dot(w, v)) / at.D),
      words("Dotted with u⊥, the part s·u drops out and only t is left. v·u⊥ is −D, so the signs in the "
            "numerator have changed too. This t belongs to the triangle; the ray's own parameter is λ."),
      {{at.s, words("{answer} is s: for t, w is dotted with u⊥.")}, wrongSignOfShare(at.t)});
}

WorkingLine placeLine(const Out &at) {
  return line(
      {withResult(at.s), withResult(at.t), withResult(at.s + at.t)},
      words("The point belongs to the triangle when none of s, t and 1 − s − t is negative. Here it is "
            "{place}.",
            {{"place", placeWords(at.meet.location, at)}}));
}

/// Where one of the triangles has no corners of its own, they have no shape.
std::string similarWords(const Out &at) {
  const WordValues points{{"P0", plainText(at.P0)},
                          {"P2", plainText(at.P2)},
                          {"A", plainText(at.A)},
                          {"B", plainText(at.B)},
                          {"C", plainText(at.C)}};
  if (at.meet.tTriangle == 0)
    return words("t is 0: {A} and {C} are {P0} itself, and there is no triangle {P0}{A}{C}.", points);
  if (at.meet.perps.uv == 0)
    return words(
        "u and v are perpendicular: {B} is {P2} itself and {A} is {C}, so the triangles are flat. Along "
        "u⊥, t·v is to v as a is to b all the same.",
        points);
  return words("The right triangles {P0}{A}{C} and {P0}{B}{P2} have the same shape, so t·v is to v as a is "
               "to b. The length of u⊥ stands in both and cancels.",
               points);
}

/// Figure 4 of the note.
WorkingLine similarLine(const Out &at) {
  const Term part = at.a / at.b;
  return line(((at.t * at.v).marked(at.C->mark) == part * at.v)
                  .then(numbersPutIn(part) * at.v)
                  .then(multipleOf(part, at.v)),
              similarWords(at));
}

void addShareLines(const Out &at, Explanation &lines) {
  lines.add("s", [&] { return lineOfS(at); });
  lines.add("t", [&] { return lineOfT(at); });
  lines.add("place", [&] { return placeLine(at); });
  lines.add("a", [&] {
    return asked(withResult(at.a == dot(at.w, at.uPerp)),
                 words("How far w reaches along u⊥, times the length of u⊥."));
  });
  lines.add("b", [&] { return asked(withResult(at.b == dot(at.v, at.uPerp)), words("The same for v.")); });
  lines.add("similar", [&] { return similarLine(at); });
}

Explanation explain(const In &, const Out &at) {
  Explanation lines;
  addSideLines(at, lines);
  if (at.meet.crosses())
    addPlaneLines(at, lines);
  lines.add("denominator", [&at] { return denominatorLine(at); });
  if (at.meet.crosses())
    addShareLines(at, lines);
  return lines;
}

/// The normal is drawn this long in every picture, whatever u×v is: only its direction matters here.
constexpr double drawnNormalLength = 3;
/// The perps are drawn a little longer than the farther of the feet on them.
constexpr double perpBeyondFoot = 1.12;

/// An arrow along a perp, long enough for this reach.
ArrowMark perpArrow(const Term &perp, const Place &from, const ExactVec3 &direction, double reach,
                    Subject subject) {
  return arrowOfLength(drawn(perp, Role::Derived, subject), from, direction, reach * perpBeyondFoot);
}

/// How far a vector reaches along a direction.
double reachAlong(const ExactVec3 &direction, const Place &vector) {
  return std::abs(glm::dot(vector, unitOf(direction)));
}

void drawSpan(Figure &figure, const Out &at) {
  const auto &perps = at.meet.perps;
  const Place p0 = place(at.P0);
  figure.add(ArrowMark{drawn(at.n, Role::Derived, Subject::Plane), p0, unitOf(perps.normal), false,
                       drawnNormalLength});
  const double reachOfW = at.meet.crosses() ? reachAlong(perps.uPerp, place(at.w)) : 0;
  figure.add(perpArrow(at.uPerp, p0, perps.uPerp, std::max(reachAlong(perps.uPerp, place(at.v)), reachOfW),
                       Subject::EdgeU));
  figure.add(perpArrow(at.vPerp, p0, perps.vPerp, reachAlong(perps.vPerp, place(at.u)), Subject::EdgeV));
}

void drawEdges(Figure &figure, const In &in, const Out &at) {
  const Role sound =
      in.T.isFree ? Role::Given : Role::Derived; // a triangle that was made is not there from the start
  const Role role = at.meet.perps.denominator != 0 ? sound : Role::Warning;
  figure.add(arrowOf(at.u, place(at.P0), role, Subject::EdgeU));
  figure.add(arrowOf(at.v, place(at.P0), role, Subject::EdgeV));
}

/// A point's foot on u⊥, with the way there.
void drawFoot(Figure &figure, const Out &at, const Term &foot, const Place &point) {
  const Place p0 = place(at.P0);
  const Place end = place(foot);
  figure.add(SegmentMark{{foot->mark + "/way", Role::Helper, Subject::Measure}, point, end});
  figure.add(pointOf(foot, Role::Derived, Subject::Measure));
  if (vectorOf(foot) != vectorOf(at.P0))
    figure.add(
        RightAngleMark{{foot->mark + "/angle", Role::Helper, Subject::Measure}, end, p0 - end, point - end});
}

/// Figure 4 of the note: the similar right triangles of t·v and v. From the tip of t·v the part s·u leads to
/// I, along the way to the foot: so I has the same foot.
void drawSimilarTriangles(Figure &figure, const Out &at) {
  figure.add(pointOf(at.C, Role::Derived, Subject::EdgeV));
  figure.add(SegmentMark{{at.C->mark + "/su", Role::Helper, Subject::EdgeU}, place(at.C), place(at.I)});
  drawFoot(figure, at, at.A, place(at.C));
  drawFoot(figure, at, at.B, place(at.P2));
}

Figure draw(const In &in, const Out &at) {
  Figure figure;
  const bool crosses = at.meet.crosses();
  const bool ahead = at.meet.plane.which == RayPlaneCase::Hit;
  const Place point = place(at.I);
  if (at.meet.perps.denominator != 0)
    drawSpan(figure, at);
  drawEdges(figure, in, at);
  if (!crosses)
    return figure;
  if (ahead)
    figure.reaches.push_back({in.L.id, point});
  else
    figure.add(SegmentMark{{at.I->mark + "/backward", Role::Ghost, Subject::Ray}, place(at.Q), point});
  figure.add(wayToHit(at.w, place(at.P0)));
  drawSimilarTriangles(figure, at);
  const bool hit = at.meet.which == RayTriangleCase::Hit;
  figure.add(pointOf(at.I, hit ? Role::Result : Role::Ghost, Subject::Ray));
  return figure;
}

std::vector<SpecialCase> nearby(const In &in, const Out &at) {
  return rayTriangleNearby(in.T.object, in.L.object, at, at);
}

} // namespace

Construction ray_triangle_perp() {
  return makeConstruction<In, Out, TriangleObject, RayObject>(
      "ray-triangle-perp", {"T", "L"}, {{"I", "point"}},
      {"u", "v", "n", "D", "λ", "w", "s", "t", "a", "b", "A", "B", "C"},
      {.cases = {"hit", "behind", "miss", "parallel", "in-plane", "zero-direction", "coincident",
                 "collinear"},
       .values = {named::word("location", {"interior", "edge", "vertex", "outside"}), named::index("feature"),
                  named::number("t"), named::vector("point"), named::number("s"), named::number("t_triangle"),
                  named::list("barycentric", 3),
                  named::group("perp", {named::vector("u_perp"), named::vector("v_perp"), named::number("uu"),
                                        named::number("uv"), named::number("vv"), named::number("wu"),
                                        named::number("wv"), named::number("denominator")})},
       .lines = {"u", "v",  "normal", "uu",          "uv", "vv", "uperp", "vperp", "plane-t", "hit",
                 "w", "wu", "wv",     "denominator", "s",  "t",  "place", "a",     "b",       "similar"},
       .marks = {"n", "uperp", "vperp", "u", "v", "w", "A", "B", "C", "I"}},
      {compute, tell, valuesOf, make, explain, draw, nearby});
}

} // namespace halfspace
