// Where a ray meets a triangle, by u⊥ and v⊥ with five dot products (note PG 6.2, figure 4). The ray's
// parameter is λ here, because s and t belong to the triangle.
#include "geometry/intersect_ray_triangle.h"
#include "lessons/construction.h"
#include "lessons/drawing.h"
#include "lessons/given.h"
#include "lessons/term/rewrite.h"
#include "lessons/triangle_words.h"
#include "lessons/words.h"
#include "lessons/worked_lines.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace halfspace {
namespace {

struct In {
  TriangleObject T;
  RayObject L;
};

struct Out {
  RayTriangle<Rational> meet; // u, v, n, perps, the five dot products, s, t, place
  Rational wOnUPerp;          // a = w·u⊥
  Rational vOnUPerp;          // b = v·u⊥
  std::vector<Surd> barycentric;
  ExactVec3 tv;    // P0 + t·v
  ExactVec3 footA; // of w on the line P0 + u⊥, a along u⊥
  ExactVec3 footB; // of v on it, b along u⊥
};

Out compute(const In &in) {
  Out out;
  out.meet = intersectRayTriangle(Ray<Rational>{in.L.origin, in.L.direction},
                                  Triangle<Rational>{in.T.p0, in.T.p1, in.T.p2});
  if (!out.meet.crosses())
    return out;
  const auto &perps = out.meet.perps;
  out.wOnUPerp = dot(out.meet.w, perps.uPerp);
  out.vOnUPerp = dot(perps.v, perps.uPerp);
  out.barycentric = {Rational(1 - out.meet.s - out.meet.tTriangle), out.meet.s, out.meet.tTriangle};
  out.tv = in.T.p0 + perps.v * out.meet.tTriangle;
  const Rational perpSquared = dot(perps.uPerp, perps.uPerp);
  out.footA = in.T.p0 + perps.uPerp * Rational(out.wOnUPerp / perpSquared);
  out.footB = in.T.p0 + perps.uPerp * Rational(out.vOnUPerp / perpSquared);
  return out;
}

/// The letters of the lines.
struct Letters : TriangleTerms, RayTerms {
  Term u, v, n, uPerp, vPerp;
  Term lambda, I, w, D, s, t, a, b;
};

Letters lettersOf(const In &in, const Out &out) {
  const auto &meet = out.meet;
  const auto &perps = meet.perps;
  return {termsOf(in.T, "T"),
          termsOf(in.L, "L"),
          name(vectorLetter("u"), perps.u).marked("u"),
          name(vectorLetter("v"), perps.v).marked("v"),
          name(vectorLetter("n"), perps.normal).marked("n"),
          name(perpLetter("u"), perps.uPerp).marked("uperp"),
          name(perpLetter("v"), perps.vPerp).marked("vperp"),
          name(letter("λ"), meet.plane.t),
          name(letter("I"), meet.plane.point).marked("I"),
          name(vectorLetter("w"), meet.w).marked("w"),
          name(letter("D"), perps.denominator),
          name(letter("s"), meet.s),
          name(letter("t"), meet.tTriangle),
          name(letter("a"), out.wOnUPerp).marked("a"),
          name(letter("b"), out.vOnUPerp).marked("b")};
}

CaseWords tell(const In &in, const Out &out) {
  const Letters at = lettersOf(in, out);
  const std::string lambda = equation(at.lambda);
  switch (out.meet.which) {
  case RayTriangleCase::Hit:
    return {"hit", words("The ray hits {place}, at {lambda}.",
                         {{"place", placeWords(out.meet.place)}, {"lambda", lambda}})};
  case RayTriangleCase::Behind:
    return {"behind", words("{lambda} is negative: the triangle is behind the ray's start. The line "
                            "backwards would meet it {place}.",
                            {{"place", placeWords(out.meet.place)}, {"lambda", lambda}})};
  case RayTriangleCase::Miss:
    return {"miss", words("The line meets the triangle's plane outside the triangle: {s}, {t}, {sum}.",
                          {{"s", equation(at.s)}, {"t", equation(at.t)}, {"sum", equation(at.s + at.t)}})};
  case RayTriangleCase::Parallel:
    return {"parallel", words("r·n = 0: the ray runs parallel to the triangle's plane and never meets it.")};
  case RayTriangleCase::InPlane:
    return {"in-plane", words("r·n = 0 and Q lies in the triangle's plane: the ray runs inside it, and no "
                              "single point is the hit.")};
  case RayTriangleCase::ZeroDirection:
    return {"zero-direction", words("The direction r is the zero vector: the ray goes nowhere."), true};
  case RayTriangleCase::Coincident: {
    const int pair = in.T.p0 == in.T.p1 ? 2 : in.T.p0 == in.T.p2 ? 1 : 0;
    return {"coincident",
            words("{first} and {second} are the same point: this is no triangle, and the denominator is 0.",
                  {{"first", cornerName(pair == 0 ? 1 : 0)}, {"second", cornerName(pair == 2 ? 1 : 2)}}),
            true};
  }
  case RayTriangleCase::Collinear:
    break;
  }
  return {"collinear",
          words("P₀, P₁ and P₂ lie on one line: (u·v)² equals (u·u)(v·v), so the denominator is 0 and there "
                "is no triangle to hit."),
          true};
}

std::vector<NamedValue> perpValues(const Letters &at, const Out &out) {
  std::vector<NamedValue> values{listed("u_perp", at.uPerp), listed("v_perp", at.vPerp),
                                 listed("uu", dot(at.u, at.u)), listed("uv", dot(at.u, at.v)),
                                 listed("vv", dot(at.v, at.v))};
  if (out.meet.crosses()) {
    values.push_back(listed("wu", dot(at.w, at.u)));
    values.push_back(listed("wv", dot(at.w, at.v)));
  }
  values.push_back(listed("denominator", at.D));
  return values;
}

std::vector<NamedValue> list(const In &in, const Out &out) {
  const Letters at = lettersOf(in, out);
  std::vector<NamedValue> values;
  if (out.meet.crosses()) {
    values.push_back({"location", words("place"), std::string(nameOf(out.meet.place.location))});
    if (out.meet.place.feature >= 0)
      values.push_back({"feature", {}, out.meet.place.feature});
    values.push_back(listed("t", at.lambda));
    values.push_back(listed("point", at.I));
    values.push_back(listed("s", at.s));
    values.push_back(listed("t_triangle", at.t));
    values.push_back({"barycentric", halfspace::list({1 - at.s - at.t, at.s, at.t}), out.barycentric});
  }
  values.push_back({"perp", {}, perpValues(at, out)});
  return values;
}

WorkingLine productLine(const char *id, const Term &a, const Term &b, std::string sentence = {}) {
  return asked(line(id, {withProducts(dot(a, b))}, std::move(sentence)));
}

std::vector<WorkingLine> triangleLines(const Letters &at) {
  const auto &[u, v] = std::pair(at.u, at.v);
  return {
      asked(line("u", {withNumbers(u == at.P1 - at.P0)})),
      asked(line("v", {withNumbers(v == at.P2 - at.P0)}, words("Two sides of the triangle, both from P₀."))),
      asked(line("normal", {withResult(at.n == cross(u, v))}, words("Perpendicular to both sides."))),
      productLine("uu", u, u),
      productLine("uv", u, v),
      productLine("vv", v, v, words("Three of the five dot products: they belong to the triangle alone.")),
      asked(line("uperp", {withNumbers((at.uPerp == cross(at.n, u)) == dot(u, u) * v - dot(u, v) * u)},
                 words("u perp: in the plane of the triangle and perpendicular to u."))),
      asked(line("vperp", {withNumbers((at.vPerp == cross(at.n, v)) == dot(u, v) * v - dot(v, v) * u)},
                 words("v perp likewise: perpendicular to v.")))};
}

WorkingLine denominatorLine(const Letters &at) {
  const auto &[u, v] = std::pair(at.u, at.v);
  const bool degenerate = sign(*numberOf(at.D)) == 0;
  return asked(line("denominator", {withNumbers(at.D == power(dot(u, v), 2) - dot(u, u) * dot(v, v))},
                    degenerate
                        ? words("Zero: u and v do not span a triangle, and there is nothing to divide by.")
                        : words("The denominator of s and t. It is zero only for a degenerate triangle.")),
               {{-at.D, words("{answer} has the wrong sign: (u·v)² is never the larger part.")}});
}

WorkingLine lambdaLine(const Letters &at) {
  return asked(line("plane-t", {withNumbers(at.lambda == dot(at.P0 - at.Q, at.n) / dot(at.r, at.n))},
                    words("First the triangle's plane: so many steps r lead from Q to it.")),
               {wrongSignOf(at.lambda)});
}

WorkingLine hitLine(const Letters &at) {
  return asked(
      line("hit", {withNumbers(at.I == at.Q + at.lambda * at.r)},
           words("The point of the plane that the ray's line goes through. Is it in the triangle?")));
}

/// s or t, dotted with a perp that takes the other one away; the mistake of taking the other comes first.
WorkingLine shareLine(const char *id, const Chain &share, std::string sentence, WrongTerm other) {
  return asked(line(id, {withNumbers(share)}, std::move(sentence)),
               {std::move(other),
                {-share.sides().front(), words("{answer} has the wrong sign: the denominator D = (u·v)² − "
                                               "(u·u)(v·v) is negative.")}});
}

WorkingLine sLine(const Letters &at) {
  const auto &[u, v, w] = std::tuple(at.u, at.v, at.w);
  return shareLine("s",
                   (at.s == dot(w, at.vPerp) / dot(u, at.vPerp)) ==
                       (dot(u, v) * dot(w, v) - dot(v, v) * dot(w, u)) / at.D,
                   words("Dotted with v⊥, the part t·v drops out and only s is left."),
                   {at.t, words("{answer} is t: for s, w is dotted with v⊥.")});
}

WorkingLine tLine(const Letters &at) {
  const auto &[u, v, w] = std::tuple(at.u, at.v, at.w);
  return shareLine("t",
                   (at.t == dot(w, at.uPerp) / dot(v, at.uPerp)) ==
                       (dot(u, v) * dot(w, u) - dot(u, u) * dot(w, v)) / at.D,
                   words("Dotted with u⊥, the part s·u drops out and only t is left. This t belongs to the "
                         "triangle; the ray's own parameter is λ."),
                   {at.s, words("{answer} is s: for t, w is dotted with u⊥.")});
}

WorkingLine placeLine(const Letters &at, const Out &out) {
  return line(
      "place", {withResult(at.s), withResult(at.t), withResult(at.s + at.t)},
      words("Inside means s ≥ 0, t ≥ 0 and s + t ≤ 1. Equality in one of them is an edge only while the "
            "other two hold. Here the point is {place}.",
            {{"place", placeWords(out.meet.place)}}));
}

std::vector<WorkingLine> similarLines(const Letters &at) {
  const Term part = at.a / at.b;
  return {
      asked(line("a", {withResult(at.a == dot(at.w, at.uPerp))},
                 words("The dot product of w with u⊥: it grows with how far w reaches along u⊥."))),
      asked(line("b", {withResult(at.b == dot(at.v, at.uPerp))}, words("The same for v."))),
      line("similar",
           {((at.t * at.v).marked("tv") == part * at.v)
                .then(numbersPutIn(part) * at.v)
                .then(multipleOf(part, at.v))},
           words("Two right triangles at P₀ have the same shape, so t·v is to v as a is to b. The length of "
                 "u⊥ stands in both and cancels."))};
}

std::vector<WorkingLine> crossingLines(const Letters &at, const Out &out) {
  std::vector<WorkingLine> lines{
      lambdaLine(at), hitLine(at),
      // Not asked: I may be hidden.
      line("w", {withNumbers(at.w == at.I - at.P0)},
           words("From P₀ to that point. We look for w = s·u + t·v.")),
      productLine("wu", at.w, at.u),
      productLine("wv", at.w, at.v, words("The last two of the five dot products.")), denominatorLine(at),
      sLine(at), tLine(at), placeLine(at, out)};
  for (WorkingLine &line : similarLines(at))
    lines.push_back(std::move(line));
  return lines;
}

Working explain(const In &in, const Out &out) {
  const Letters at = lettersOf(in, out);
  Working working{triangleLines(at)};
  if (!out.meet.crosses()) {
    working.lines.push_back(denominatorLine(at));
    return working;
  }
  for (WorkingLine &line : crossingLines(at, out))
    working.lines.push_back(std::move(line));
  return working;
}

/// The normal is drawn this long in every picture, whatever u×v is: only its direction matters here.
constexpr double drawnNormalLength = 3;
/// The perps are drawn a little longer than the farther of the feet on them.
constexpr double perpBeyondFoot = 1.12;

void drawSpan(Figure &figure, const In &in, const Out &out) {
  const auto &perps = out.meet.perps;
  const Place p0 = place(in.T.p0);
  const Place pv = place(perps.v);
  const Place pu = place(perps.u);
  figure.marks.push_back(
      PolygonMark{{"T", Role::Given, Subject::Triangle, ""}, {p0, place(in.T.p1), place(in.T.p2)}});
  figure.marks.push_back(ArrowMark{
      {"n", Role::Derived, Subject::Plane, "\\vec n"}, p0, unitOf(perps.normal), false, drawnNormalLength});
  const double heightOfV = std::abs(glm::dot(pv, unitOf(perps.uPerp)));
  const double heightOfU = std::abs(glm::dot(pu, unitOf(perps.vPerp)));
  const double reachOfFeet =
      out.meet.crosses() ? std::max(heightOfV, glm::length(place(out.footA) - p0)) : heightOfV;
  figure.marks.push_back(arrowOfLength({"uperp", Role::Derived, Subject::EdgeU, "\\vec u^{\\perp}"}, p0,
                                       perps.uPerp, reachOfFeet * perpBeyondFoot));
  figure.marks.push_back(arrowOfLength({"vperp", Role::Derived, Subject::EdgeV, "\\vec v^{\\perp}"}, p0,
                                       perps.vPerp, heightOfU * perpBeyondFoot));
}

void drawEdges(Figure &figure, const In &in, const Out &out) {
  const Place p0 = place(in.T.p0);
  const bool proper = out.meet.perps.denominator != 0;
  const Role role = proper ? Role::Given : Role::Warning;
  figure.marks.push_back(ArrowMark{{"u", role, Subject::EdgeU, "\\vec u"}, p0, place(out.meet.perps.u)});
  figure.marks.push_back(ArrowMark{{"v", role, Subject::EdgeV, "\\vec v"}, p0, place(out.meet.perps.v)});
  drawCorners(figure, in.T);
}

/// Figure 4 of the note: the feet of w and v on u⊥, and the two similar right triangles that they make with
/// P0.
void drawSimilarTriangles(Figure &figure, const In &in, const Out &out) {
  const Place p0 = place(in.T.p0);
  const Place p2 = place(in.T.p2);
  const Place tv = place(out.tv);
  const Place a = place(out.footA);
  const Place b = place(out.footB);
  const Place point = place(out.meet.plane.point);
  figure.marks.push_back(SegmentMark{{"tv", Role::Derived, Subject::EdgeV, "t\\vec v"}, p0, tv});
  figure.marks.push_back(SegmentMark{{"tv-su", Role::Helper, Subject::EdgeU, ""}, tv, point});
  figure.marks.push_back(SegmentMark{{"a-foot", Role::Helper, Subject::Measure, ""}, point, a});
  figure.marks.push_back(SegmentMark{{"b-foot", Role::Helper, Subject::Measure, ""}, p2, b});
  figure.marks.push_back(PointMark{{"a", Role::Derived, Subject::Measure, "a"}, a});
  figure.marks.push_back(PointMark{{"b", Role::Derived, Subject::Measure, "b"}, b});
  if (out.wOnUPerp != 0)
    figure.marks.push_back(
        RightAngleMark{{"a-angle", Role::Helper, Subject::Measure, ""}, a, p0 - a, point - a});
  figure.marks.push_back(RightAngleMark{{"b-angle", Role::Helper, Subject::Measure, ""}, b, p0 - b, p2 - b});
}

Figure draw(const In &in, const Out &out) {
  Figure figure;
  const bool crosses = out.meet.crosses();
  const bool ahead = out.meet.plane.which == RayPlaneCase::Hit;
  const Place point = place(out.meet.plane.point);
  if (out.meet.perps.denominator != 0)
    drawSpan(figure, in, out);
  drawEdges(figure, in, out);
  drawRay(figure, in.L, crosses && ahead ? std::optional(point) : std::nullopt);
  if (!crosses)
    return figure;
  if (!ahead)
    figure.marks.push_back(
        SegmentMark{{"I-backward", Role::Ghost, Subject::Ray, ""}, place(in.L.origin), point});
  figure.marks.push_back(
      ArrowMark{{"w", Role::Derived, Subject::Neutral, "\\vec w"}, place(in.T.p0), place(out.meet.w)});
  drawSimilarTriangles(figure, in, out);
  const bool hit = out.meet.which == RayTriangleCase::Hit;
  figure.marks.push_back(PointMark{{"I", hit ? Role::Result : Role::Ghost, Subject::Ray, "I"}, point});
  return figure;
}

} // namespace

Construction ray_triangle_perp() {
  return makeConstruction<In, Out>("ray-triangle-perp", compute, tell, list, explain, draw,
                                   TypedRole<In, TriangleObject>{"T", &In::T},
                                   TypedRole<In, RayObject>{"L", &In::L});
}

} // namespace halfspace
