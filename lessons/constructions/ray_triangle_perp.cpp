// Where a ray meets a triangle, by u⊥ and v⊥ with five dot products (note PG 6.2, figure 4). The ray's
// parameter is λ here, because s and t belong to the triangle.
#include "geometry/intersect_ray_triangle.h"
#include "lessons/construction.h"
#include "lessons/drawing.h"
#include "lessons/triangle_words.h"
#include "lessons/words.h"
#include "lessons/worked_lines.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>

namespace halfspace {
namespace {

struct In {
  TriangleObject T;
  RayObject L;
};

/// s or t on the way to its value and past it.
struct Share {
  Rational numerator; // over the denominator D
  Rational opposite;
};

struct Out {
  RayTriangle<Rational> meet; // u, v, n, perps, the five dot products, s, t, place
  Rational wOnUPerp;          // a = w·u⊥
  Rational vOnUPerp;          // b = v·u⊥
  Rational wOnVPerp;          // w·v⊥
  Rational uOnVPerp;          // u·v⊥
  Rational normalSquared;     // (u×v)·(u×v): the denominator's opposite
  Share s;
  Share t;
  std::vector<Surd> barycentric;
  ExactVec3 tv;    // P0 + t·v
  ExactVec3 footA; // of w on the line P0 + u⊥, a along u⊥
  ExactVec3 footB; // of v on it, b along u⊥
};

Share shareOf(const Rational &value, const Rational &denominator) {
  return {Rational(value * denominator), Rational(-value)};
}

Out compute(const In &in) {
  Out out;
  out.meet = intersectRayTriangle(Ray<Rational>{in.L.origin, in.L.direction},
                                  Triangle<Rational>{in.T.p0, in.T.p1, in.T.p2});
  const auto &perps = out.meet.perps;
  out.normalSquared = dot(perps.normal, perps.normal);
  if (!out.meet.crosses())
    return out;
  out.wOnUPerp = dot(out.meet.w, perps.uPerp);
  out.vOnUPerp = dot(perps.v, perps.uPerp);
  out.wOnVPerp = dot(out.meet.w, perps.vPerp);
  out.uOnVPerp = dot(perps.u, perps.vPerp);
  out.s = shareOf(out.meet.s, perps.denominator);
  out.t = shareOf(out.meet.tTriangle, perps.denominator);
  const Rational rest = 1 - out.meet.s - out.meet.tTriangle;
  out.barycentric = {rest, out.meet.s, out.meet.tTriangle};
  out.tv = in.T.p0 + perps.v * out.meet.tTriangle;
  const Rational perpSquared = dot(perps.uPerp, perps.uPerp);
  out.footA = in.T.p0 + perps.uPerp * Rational(out.wOnUPerp / perpSquared);
  out.footB = in.T.p0 + perps.uPerp * Rational(out.vOnUPerp / perpSquared);
  return out;
}

CaseWords tell(const In &in, const Out &out) {
  const std::string lambda = equation("λ", out.meet.plane.t);
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
                          {{"s", equation("s", out.meet.s)},
                           {"t", equation("t", out.meet.tTriangle)},
                           {"sum", equation("s + t", Rational(out.meet.s + out.meet.tTriangle))}})};
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

const std::string Q = marked("Q", "Q");
const std::string r = marked("r", "\\vec r");
const std::string P0 = marked("P0", "P_0");
const std::string P1 = marked("P1", "P_1");
const std::string P2 = marked("P2", "P_2");
const std::string u = marked("u", "\\vec u");
const std::string v = marked("v", "\\vec v");
const std::string n = marked("n", "\\vec n");
const std::string w = marked("w", "\\vec w");
const std::string uPerp = marked("uperp", "\\vec u^{\\perp}");
const std::string vPerp = marked("vperp", "\\vec v^{\\perp}");
const std::string I = marked("I", "I");

std::vector<NamedValue> perpValues(const Out &out) {
  const auto &perps = out.meet.perps;
  std::vector<NamedValue> values{{"u_perp", uPerp, listOf(perps.uPerp)},
                                 {"v_perp", vPerp, listOf(perps.vPerp)},
                                 {"uu", u + "\\cdot " + u, Surd(perps.uu)},
                                 {"uv", u + "\\cdot " + v, Surd(perps.uv)},
                                 {"vv", v + "\\cdot " + v, Surd(perps.vv)}};
  if (out.meet.crosses()) {
    values.push_back({"wu", w + "\\cdot " + u, Surd(out.meet.wu)});
    values.push_back({"wv", w + "\\cdot " + v, Surd(out.meet.wv)});
  }
  values.push_back({"denominator", "D", Surd(perps.denominator)});
  return values;
}

std::vector<NamedValue> list(const Out &out) {
  std::vector<NamedValue> values;
  if (out.meet.crosses()) {
    values.push_back({"location", "\\text{place}", std::string(nameOf(out.meet.place.location))});
    if (out.meet.place.feature >= 0)
      values.push_back({"feature", "", out.meet.place.feature});
    values.push_back({"t", "\\lambda", Surd(out.meet.plane.t)});
    values.push_back({"point", I, listOf(out.meet.plane.point)});
    values.push_back({"s", "s", Surd(out.meet.s)});
    values.push_back({"t_triangle", "t", Surd(out.meet.tTriangle)});
    values.push_back({"barycentric", "(1-s-t,\\ s,\\ t)", out.barycentric});
  }
  values.push_back({"perp", "", perpValues(out)});
  return values;
}

/// n×u = (u·u)v − (u·v)u and n×v = (u·v)v − (v·v)u: both are k·v − l·u.
WorkingLine perpLine(std::string id, std::string symbols, const Rational &k, const Rational &l,
                     const TrianglePerps<Rational> &perps, const ExactVec3 &result, std::string sentence) {
  Formula f;
  const std::string inserted = f.equals(f.factor(k) + f(perps.v) + " - " + f.factor(l) + f(perps.u));
  return {std::move(id), std::move(symbols), inserted, equalTo(result), std::move(sentence)};
}

std::vector<WorkingLine> triangleLines(const In &in, const TrianglePerps<Rational> &perps) {
  Formula f;
  const std::string normal = f.equals(f(perps.normal));
  return {
      differenceLine({"u", u + " = " + P1 + " - " + P0, ""}, in.T.p1, in.T.p0, perps.u),
      differenceLine({"v", v + " = " + P2 + " - " + P0, words("Two sides of the triangle, both from P₀.")},
                     in.T.p2, in.T.p0, perps.v),
      {"normal", n + " = " + u + "\\times " + v, "", normal, words("Perpendicular to both sides.")},
      dotLine({"uu", u + "\\cdot " + u, ""}, perps.u, perps.u, perps.uu),
      dotLine({"uv", u + "\\cdot " + v, ""}, perps.u, perps.v, perps.uv),
      dotLine({"vv", v + "\\cdot " + v,
               words("Three of the five dot products: they belong to the triangle alone.")},
              perps.v, perps.v, perps.vv),
      perpLine("uperp",
               uPerp + " = " + n + "\\times " + u + " = (" + u + "\\cdot " + u + ")" + v + " - (" + u +
                   "\\cdot " + v + ")" + u,
               perps.uu, perps.uv, perps, perps.uPerp,
               words("u perp: in the plane of the triangle and perpendicular to u.")),
      perpLine("vperp",
               vPerp + " = " + n + "\\times " + v + " = (" + u + "\\cdot " + v + ")" + v + " - (" + v +
                   "\\cdot " + v + ")" + u,
               perps.uv, perps.vv, perps, perps.vPerp, words("v perp likewise: perpendicular to v.")),
  };
}

WorkingLine denominatorLine(const Out &out) {
  const auto &perps = out.meet.perps;
  Formula f;
  const std::string inserted =
      f.equals(f.squared(perps.uv) + " - " + f.factor(perps.uu) + "\\cdot " + f.factor(perps.vv));
  const bool degenerate = perps.denominator == 0;
  return {
      "denominator",
      "D = (" + u + "\\cdot " + v + ")^2 - (" + u + "\\cdot " + u + ")(" + v + "\\cdot " + v + ")",
      inserted,
      equalTo(perps.denominator),
      degenerate ? words("Zero: u and v do not span a triangle, and there is nothing to divide by.")
                 : words("The denominator of s and t. It is zero only for a degenerate triangle."),
      Blank{perps.denominator,
            {{out.normalSquared, words("{answer} has the wrong sign: (u·v)² is never the larger part.")}}}};
}

WorkingLine lambdaLine(const Out &out) {
  return parameterLine(
      {"plane-t", "\\lambda = \\frac{(" + P0 + " - " + Q + ")\\cdot " + n + "}{" + r + "\\cdot " + n + "}",
       words("First the triangle's plane: so many steps r lead from Q to it.")},
      out.meet.plane.numerator, out.meet.plane.denominator, out.meet.plane.t);
}

WorkingLine hitLine(const In &in, const Out &out) {
  return pointLine({"hit", I + " = " + Q + " + \\lambda\\," + r,
                    words("The point of the plane that the ray's line goes through. Is it in the triangle?")},
                   in.L.origin, out.meet.plane.t, in.L.direction, out.meet.plane.point);
}

/// s or t as a fraction of the five dot products: (k·l − m·n)/D, with k, l, m, n the factors.
std::string shareNumbers(const std::array<Rational, 4> &factors, const Rational &denominator) {
  Formula f;
  const auto product = [&](std::size_t i) {
    return f.factor(factors[i]) + "\\cdot " + f.factor(factors[i + 1]);
  };
  const std::string first = product(0);
  const std::string second = product(2);
  return f.equals("\\frac{" + first + " - " + second + "}{" + f(denominator) + "}");
}

/// The symbols of s or t: dotted with a perp that takes the other one away, then with the numbers' names.
std::string shareSymbols(const char *share, const std::string &side, const std::string &perp,
                         const std::string &numerator) {
  return std::string(share) + " = \\frac{" + w + "\\cdot " + perp + "}{" + side + "\\cdot " + perp +
         "} = \\frac{" + numerator + "}{D}";
}

std::string dotted(const std::string &a, const std::string &b) { return "(" + a + "\\cdot " + b + ")"; }

/// What is asked for a share, when the other one is `other`.
Blank shareBlank(const Share &share, const Rational &denominator, Mistake other) {
  Blank blank = fractionBlank(share.numerator, denominator);
  blank.mistakes.insert(blank.mistakes.begin(), std::move(other));
  blank.mistakes.push_back(
      {share.opposite, words("{answer} has the wrong sign: the denominator D = (u·v)² − (u·u)(v·v) is "
                             "negative.")});
  return blank;
}

WorkingLine sLine(const Out &out) {
  const auto &perps = out.meet.perps;
  return {"s",
          shareSymbols("s", u, vPerp, dotted(u, v) + dotted(w, v) + " - " + dotted(v, v) + dotted(w, u)),
          shareNumbers({perps.uv, out.meet.wv, perps.vv, out.meet.wu}, perps.denominator),
          equalTo(out.meet.s),
          words("Dotted with v⊥, the part t·v drops out and only s is left."),
          shareBlank(out.s, perps.denominator,
                     {out.meet.tTriangle, words("{answer} is t: for s, w is dotted with v⊥.")})};
}

WorkingLine tLine(const Out &out) {
  const auto &perps = out.meet.perps;
  return {"t",
          shareSymbols("t", v, uPerp, dotted(u, v) + dotted(w, u) + " - " + dotted(u, u) + dotted(w, v)),
          shareNumbers({perps.uv, out.meet.wu, perps.uu, out.meet.wv}, perps.denominator),
          equalTo(out.meet.tTriangle),
          words("Dotted with u⊥, the part s·u drops out and only t is left. This t belongs to the "
                "triangle; the ray's own parameter is λ."),
          shareBlank(out.t, perps.denominator,
                     {out.meet.s, words("{answer} is s: for t, w is dotted with u⊥.")})};
}

WorkingLine placeLine(const Out &out) {
  Formula f;
  const std::string sum = f(Rational(out.meet.s + out.meet.tTriangle));
  const std::string values =
      f(out.meet.s) + ",\\quad t " + f.equals(f(out.meet.tTriangle)) + ",\\quad s + t " + f.equals(sum);
  return {"place", "s", f.equals(values), "",
          words("Inside means s ≥ 0, t ≥ 0 and s + t ≤ 1. Equality in one of them is an edge only while the "
                "other two hold. Here the point is {place}.",
                {{"place", placeWords(out.meet.place)}})};
}

std::vector<WorkingLine> similarLines(const Out &out) {
  Formula fa;
  Formula fb;
  Formula f;
  Formula g;
  const std::string ratio = f.quotient(out.wOnUPerp, out.vOnUPerp);
  const std::string part = f.equals(ratio + "\\," + v);
  const std::string reduced = g(out.meet.tTriangle);
  const std::string whole = g.equals(reduced + "\\," + v);
  const std::string a = marked("a", "a");
  const std::string b = marked("b", "b");
  return {
      {"a", a + " = " + w + "\\cdot " + uPerp, fa.equals(fa(out.wOnUPerp)), "",
       words("The dot product of w with u⊥: it grows with how far w reaches along u⊥."), Blank{out.wOnUPerp}},
      {"b", b + " = " + v + "\\cdot " + uPerp, fb.equals(fb(out.vOnUPerp)), "", words("The same for v."),
       Blank{out.vOnUPerp}},
      {"similar", marked("tv", "t\\,\\vec v") + " = \\frac{" + a + "}{" + b + "}\\," + v, part, whole,
       words("Two right triangles at P₀ have the same shape, so t·v is to v as a is to b. The length of u⊥ "
             "stands in both and cancels.")}};
}

std::vector<WorkingLine> crossingLines(const In &in, const Out &out) {
  const auto &perps = out.meet.perps;
  const auto &meet = out.meet;
  std::vector<WorkingLine> lines{
      lambdaLine(out),
      hitLine(in, out),
      differenceLine(
          {"w", w + " = " + I + " - " + P0, words("From P₀ to that point. We look for w = s·u + t·v.")},
          meet.plane.point, in.T.p0, meet.w),
      dotLine({"wu", w + "\\cdot " + u, ""}, meet.w, perps.u, meet.wu),
      dotLine({"wv", w + "\\cdot " + v, words("The last two of the five dot products.")}, meet.w, perps.v,
              meet.wv),
      denominatorLine(out),
      sLine(out),
      tLine(out),
      placeLine(out)};
  for (WorkingLine &line : similarLines(out))
    lines.push_back(std::move(line));
  return lines;
}

Working explain(const In &in, const Out &out) {
  Working working{triangleLines(in, out.meet.perps)};
  if (out.meet.crosses())
    for (WorkingLine &line : crossingLines(in, out))
      working.lines.push_back(std::move(line));
  else
    working.lines.push_back(denominatorLine(out));
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
