// Where a ray meets a plane, by substitution and by dot products (notes PG 4 and 5; facing normal: note RP
// 28).
#include "geometry/intersect_ray_plane.h"
#include "lessons/construction.h"
#include "lessons/drawing.h"
#include "lessons/words.h"
#include "lessons/worked_lines.h"

namespace halfspace {
namespace {

struct In {
  PlaneObject E;
  RayObject L;
};

struct Out {
  Plane<Rational> plane;
  std::vector<Surd> coefficients;
  ExactVec3 toPlane;          // P0 − Q
  Rational f;                 // f(Q), the constant left after substitution
  RayPlane<Rational> meet;    // numerator, denominator, t, point
  std::array<Surd, 3> facing; // the facing normal, where the ray's line crosses the plane
};

Out compute(const In &in) {
  Out out;
  out.plane = planeThrough(in.E.point, in.E.normal);
  out.coefficients = coefficientsOf(out.plane);
  out.toPlane = in.E.point - in.L.origin;
  out.f = evaluate(out.plane, in.L.origin);
  out.meet = intersectRayPlane(Ray<Rational>{in.L.origin, in.L.direction}, out.plane);
  if (out.meet.crosses())
    out.facing = facingNormal(in.E.normal, in.L.direction);
  return out;
}

CaseWords tell(const In &, const Out &out) {
  const std::string t = equation("t", out.meet.t);
  switch (out.meet.which) {
  case RayPlaneCase::Hit:
    if (out.meet.t == 0)
      return {"hit", words("t = 0: the ray starts in the plane, so it hits at its own start.")};
    return {"hit", words("{t} is positive: the ray hits the plane.", {{"t", t}})};
  case RayPlaneCase::Behind:
    return {"behind",
            words("{t} is negative: the plane is behind the ray's start, so the ray does not hit it.",
                  {{"t", t}})};
  case RayPlaneCase::Parallel:
    return {"parallel",
            words("r·n = 0 but (P₀ − Q)·n is not: the ray runs parallel to the plane and never meets it.")};
  case RayPlaneCase::InPlane:
    return {"in-plane", words("r·n = 0 and (P₀ − Q)·n = 0: the ray lies in the plane. Every t fits, so 0/0 "
                              "names no single point.")};
  case RayPlaneCase::ZeroDirection:
    return {"zero-direction", words("The direction r is the zero vector: the ray goes nowhere."), true};
  case RayPlaneCase::ZeroNormal:
    break;
  }
  return {"zero-normal", words("The normal n is the zero vector: it points nowhere, so there is no plane."),
          true};
}

const std::string n = marked("n", "\\vec n");
const std::string r = marked("r", "\\vec r");
const std::string P0 = marked("P0", "P_0");
const std::string Q = marked("Q", "Q");
const std::string H = marked("H", "H");

/// Facing normal's mark, only in the figure when the line crosses the plane.
const std::string facing = marked("facing", "\\vec n_{f}");

std::vector<NamedValue> list(const Out &out) {
  std::vector<NamedValue> values{{"numerator", "(" + P0 + "-" + Q + ")\\cdot " + n, Surd(out.meet.numerator)},
                                 {"denominator", r + "\\cdot " + n, Surd(out.meet.denominator)}};
  if (!out.meet.crosses())
    return values;
  values.push_back({"t", "t", Surd(out.meet.t)});
  values.push_back({"point", H, listOf(out.meet.point)});
  values.push_back({"facing_normal", facing, std::vector<Surd>(out.facing.begin(), out.facing.end())});
  return values;
}

/// (11 − t), (15 + 3t): one coordinate of Q + t·r
std::string alongRay(Formula &f, const Rational &start, const Rational &step) {
  return f.linear({Surd(step), Surd(start)}, {"t"});
}

WorkingLine substituteLine(const In &in, const Out &out) {
  Formula f;
  std::string sum;
  for (int i = 0; i < 3; ++i)
    sum += (i == 0 ? "" : " + ") + f.factor(in.E.normal[i]) + "(" +
           alongRay(f, in.L.origin[i], in.L.direction[i]) + ")";
  sum += f.addend(out.plane.offset);
  return {"substitute", "0 = " + n + "\\cdot(" + Q + " + t\\," + r + ") + d", f.equals(sum), "",
          words("The ray's points Q + t·r put into the plane's equation. One unknown is left: t.")};
}

WorkingLine collectLine(const Out &out) {
  Formula f;
  const std::string sum = f.linear({Surd(out.meet.denominator), Surd(out.f)}, {"t"});
  return {"collect", "0 = (" + r + "\\cdot " + n + ")\\,t + f(" + Q + ")", f.equals(sum), "",
          words("Collected by t: r·n stands before t, and f(Q) is left over.")};
}

WorkingLine numeratorLine(const In &in, const Out &out) {
  WorkingLine line =
      shortDotLine({"numerator", "(" + P0 + " - " + Q + ")\\cdot " + n,
                    words("The same by dot products. The numerator is −f(Q): how far the plane is from Q, "
                          "measured along n.")},
                   out.toPlane, in.E.normal, out.meet.numerator);
  line.blank->mistakes = {
      {out.f, words("{answer} is f(Q) = n·(Q − P₀): the numerator goes the other way, from Q to P₀.")}};
  return line;
}

WorkingLine denominatorLine(const In &in, const Out &out) {
  return shortDotLine({"denominator", r + "\\cdot " + n,
                       words("The denominator: how far one step r goes along n. Zero means that no step "
                             "along r comes nearer to the plane.")},
                      in.L.direction, in.E.normal, out.meet.denominator);
}

WorkingLine tLine(const Out &out) {
  return parameterLine(
      {"t", "t = \\frac{(" + P0 + " - " + Q + ")\\cdot " + n + "}{" + r + "\\cdot " + n + "}",
       words("So many steps r lead from Q to the plane. It is a distance only when |r| = 1.")},
      out.meet.numerator, out.meet.denominator, out.meet.t);
}

WorkingLine hitLine(const In &in, const Out &out) {
  return pointLine({"hit", H + " = " + Q + " + t\\," + r,
                    out.meet.which == RayPlaneCase::Hit
                        ? words("The point where the ray meets the plane.")
                        : words("Here the line through the ray meets the plane, behind the start: the ray "
                                "itself never gets there.")},
                   in.L.origin, out.meet.t, in.L.direction, out.meet.point);
}

WorkingLine facingLine(const Out &out) {
  Formula f;
  const std::string unit = f.list({out.facing.begin(), out.facing.end()});
  const bool flipped = out.meet.denominator > 0;
  return {"facing", facing + " = " + (flipped ? "-" : "") + "\\frac{" + n + "}{\\lvert" + n + "\\rvert}",
          f.equals(unit), "",
          flipped ? words("r·n is positive, so n points away from where the ray comes from: the facing "
                          "normal is −n, made one unit long.")
                  : words("r·n is negative, so n already points to where the ray comes from: the facing "
                          "normal is n, made one unit long.")};
}

Working explain(const In &in, const Out &out) {
  Working working{
      {substituteLine(in, out), collectLine(out), numeratorLine(in, out), denominatorLine(in, out)}};
  if (out.meet.crosses())
    for (WorkingLine &line : std::vector<WorkingLine>{tLine(out), hitLine(in, out), facingLine(out)})
      working.lines.push_back(std::move(line));
  return working;
}

/// The unit normal is drawn this long in every picture.
constexpr double drawnNormalLength = 1;

Figure draw(const In &in, const Out &out) {
  Figure figure;
  const bool crosses = out.meet.crosses();
  const bool hit = out.meet.which == RayPlaneCase::Hit;
  const Place meeting = place(out.meet.point);
  const Place q = place(in.L.origin);
  drawPlane(figure, in.E, out.coefficients, crosses ? std::vector{meeting} : std::vector<Place>{});
  drawRay(figure, in.L, hit ? std::optional(meeting) : std::nullopt);
  if (!crosses)
    return figure;
  if (!hit)
    figure.marks.push_back(SegmentMark{{"H-backward", Role::Ghost, Subject::Ray, ""}, q, meeting});
  figure.marks.push_back(PointMark{{"H", hit ? Role::Result : Role::Ghost, Subject::Ray, "H"}, meeting});
  const auto &unit = out.facing;
  figure.marks.push_back(ArrowMark{{"facing", Role::Derived, Subject::Measure, "\\vec n_{f}"},
                                   meeting,
                                   {toDouble(unit[0]), toDouble(unit[1]), toDouble(unit[2])},
                                   false,
                                   drawnNormalLength});
  return figure;
}

} // namespace

Construction ray_plane_dot() {
  return makeConstruction<In, Out>("ray-plane-dot", compute, tell, list, explain, draw,
                                   TypedRole<In, PlaneObject>{"E", &In::E},
                                   TypedRole<In, RayObject>{"L", &In::L});
}

} // namespace halfspace
