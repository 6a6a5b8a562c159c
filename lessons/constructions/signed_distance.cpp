// How far a point is from a plane, and on which side (notes PG 3.4 and 3.5, figure 1).
#include "geometry/point_plane.h"
#include "lessons/construction.h"
#include "lessons/drawing.h"
#include "lessons/words.h"
#include "lessons/worked_lines.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halfspace {
namespace {

struct In {
  PlaneObject E;
  PointObject Q;
};

struct Out {
  Plane<Rational> plane;
  std::vector<Surd> coefficients;
  PointPlane<Rational> measured; // f, signed distance, foot
  Surd length;                   // |n|
  ExactVec3 w;                   // Q − P0
  bool atP0 = false;             // w is zero: there is no angle
  Surd wLength;                  // |w|
  Surd cosine;                   // of the angle θ between n and w
  Rational nQ;                   // n·Q: what is left when P0 is forgotten
  Rational fWithoutSign;         // |f|
  Surd oppositeDistance;         // −(signed distance)
};

Out compute(const In &in) {
  Out out;
  out.plane = planeThrough(in.E.point, in.E.normal);
  out.coefficients = coefficientsOf(out.plane);
  out.measured = measurePointPlane(in.Q.at, out.plane);
  out.w = in.Q.at - in.E.point;
  out.nQ = dot(in.E.normal, in.Q.at);
  out.fWithoutSign = abs(out.measured.f);
  out.atP0 = isZero(out.w);
  if (out.measured.which == PointPlaneCase::ZeroNormal)
    return out;
  out.length = Surd::root(out.measured.normalSquared);
  out.oppositeDistance = -out.measured.signedDistance;
  const Rational wSquared = dot(out.w, out.w);
  out.wLength = Surd::root(wSquared);
  if (!out.atP0)
    out.cosine = overRoot(out.measured.f, Rational(out.measured.normalSquared * wSquared));
  return out;
}

CaseWords tell(const In &, const Out &out) {
  const std::string f = equation("f(Q)", out.measured.f);
  const std::string distance = equation("signed distance", out.measured.signedDistance);
  switch (out.measured.which) {
  case PointPlaneCase::Positive:
    return {"positive", words("{f} is positive: Q lies on the side that n points to, {distance}.",
                              {{"f", f}, {"distance", distance}})};
  case PointPlaneCase::Negative:
    return {"negative", words("{f} is negative: Q lies on the side that n points away from, {distance}.",
                              {{"f", f}, {"distance", distance}})};
  case PointPlaneCase::On:
    return {"on", words("f(Q) = 0: Q lies in the plane, and is its own foot.")};
  case PointPlaneCase::ZeroNormal:
    break;
  }
  return {"zero-normal", words("The normal n is the zero vector: it points nowhere, so there is no plane."),
          true};
}

std::string sideName(PointPlaneCase which) {
  return which == PointPlaneCase::Positive   ? "positive"
         : which == PointPlaneCase::Negative ? "negative"
                                             : "on";
}

const std::string n = marked("n", "\\vec n");
const std::string P0 = marked("P0", "P_0");
const std::string Q = marked("Q", "Q");
const std::string F = marked("F", "F");
const std::string w = marked("w", "\\vec w");
const std::string dist = marked("distance", "\\operatorname{dist}");
const std::string theta = marked("theta", "\\theta");

std::vector<NamedValue> list(const Out &out) {
  std::vector<NamedValue> values{{"f", "f(" + Q + ")", Surd(out.measured.f)}};
  if (out.measured.which == PointPlaneCase::ZeroNormal)
    return values;
  values.push_back({"signed_distance", dist, out.measured.signedDistance});
  values.push_back({"side", "\\text{side}", sideName(out.measured.which)});
  values.push_back({"foot", F, listOf(out.measured.foot)});
  if (!out.atP0)
    values.push_back({"cos_angle", "\\cos" + theta, out.cosine});
  return values;
}

WorkingLine fLine(const In &in, const Out &out) {
  WorkingLine line = shortDotLine({"f", "f(" + Q + ") = " + n + "\\cdot(" + Q + " - " + P0 + ")",
                                   words("Q put into the left side of the plane's equation.")},
                                  in.E.normal, out.w, out.measured.f);
  line.blank->mistakes = {{out.nQ, words("{answer} is n·Q: P₀ is to be subtracted from Q first.")}};
  return line;
}

WorkingLine sideLine(const Out &out) {
  switch (out.measured.which) {
  case PointPlaneCase::Positive:
    return {"side", "f(" + Q + ") > 0", "", "", words("The sign tells the side: positive where n points.")};
  case PointPlaneCase::Negative:
    return {"side", "f(" + Q + ") < 0", "", "",
            words("The sign tells the side: negative behind the plane, seen along n.")};
  default:
    return {"side", "f(" + Q + ") = 0", "", "",
            words("Zero: Q satisfies the plane's equation, so it lies in the plane.")};
  }
}

WorkingLine lengthLine(const In &in, const Out &out) {
  Formula f;
  const std::string inserted = f.equals("\\sqrt{" + f.products(in.E.normal, in.E.normal) + "}");
  return {"length",
          "\\lvert" + n + "\\rvert = \\sqrt{" + n + "\\cdot " + n + "}",
          inserted,
          equalTo(out.length),
          words("The length of the normal."),
          Blank{out.length,
                {{out.measured.normalSquared, words("{answer} is n·n: its root is still to be taken.")}}}};
}

Blank distanceBlank(const Out &out) {
  return {out.measured.signedDistance,
          {{out.measured.f, words("{answer} is f(Q): n is not normalized, so divide by |n|.")},
           {out.fWithoutSign, words("{answer} is f(Q) without its sign, and not divided by |n| either.")},
           {out.measured.footParameter, words("{answer} is f(Q)/(n·n): divide by the root of n·n, |n|.")},
           {out.oppositeDistance, words("{answer} has the wrong sign: the distance has the sign of f(Q).")}}};
}

WorkingLine distanceLine(const Out &out) {
  Formula f;
  const std::string inserted = f.equals(f.quotient(out.measured.f, out.length));
  const bool unit = out.measured.normalSquared == 1;
  return {
      "distance",
      dist + " = \\frac{f(" + Q + ")}{\\lvert" + n + "\\rvert}",
      inserted,
      equalTo(out.measured.signedDistance),
      unit ? words("Because |n| = 1, f(Q) is the signed distance already.")
           : words("{f} is not the distance: n is {length} long, so f(Q) is so many times as large.",
                   {{"f", equation("f(Q)", out.measured.f)}, {"length", plainText(show(out.length).latex)}}),
      distanceBlank(out)};
}

WorkingLine cosineLine(const Out &out) {
  Formula f;
  const std::string inserted =
      f.equals("\\frac{" + f(out.measured.f) + "}{" + f(out.length) + "\\cdot " + f(out.wLength) + "}");
  const double degrees = std::acos(std::clamp(toDouble(out.cosine), -1.0, 1.0)) * 180 / std::numbers::pi;
  return {"cosine",
          "\\cos" + theta + " = \\frac{" + n + "\\cdot " + w + "}{\\lvert" + n + "\\rvert\\,\\lvert" + w +
              "\\rvert}",
          inserted,
          equalTo(out.cosine),
          words("θ ≈ {degrees}° is the angle between n and w = Q − P₀. So dist = |w| cos θ is the part of w "
                "that runs along n.",
                {{"degrees", roundedText(degrees)}}),
          Blank{out.cosine,
                {{out.measured.signedDistance, words("{answer} is the distance: divide by |w| as well.")},
                 {out.measured.f, words("{answer} is n·w: divide by both lengths.")}}}};
}

WorkingLine footLine(const In &in, const Out &out) {
  Formula f;
  const std::string inserted =
      f.equals(f(in.Q.at) + " - " + f.quotient(out.measured.f, out.measured.normalSquared) + f(in.E.normal));
  return {"foot", F + " = " + Q + " - \\frac{f(" + Q + ")}{" + n + "\\cdot " + n + "}\\," + n, inserted,
          equalTo(out.measured.foot),
          words("The foot: from Q straight along n to the plane, its nearest point.")};
}

Working explain(const In &in, const Out &out) {
  if (out.measured.which == PointPlaneCase::ZeroNormal)
    return {{fLine(in, out)}};
  Working working{{fLine(in, out), sideLine(out), lengthLine(in, out), distanceLine(out)}};
  if (!out.atP0)
    working.lines.push_back(cosineLine(out));
  working.lines.push_back(footLine(in, out));
  return working;
}

Figure draw(const In &in, const Out &out) {
  Figure figure;
  const Place q = place(in.Q.at);
  const Place p0 = place(in.E.point);
  const Place normal = place(in.E.normal);
  const bool hasPlane = out.measured.which != PointPlaneCase::ZeroNormal;
  const Place foot = hasPlane ? place(out.measured.foot) : p0;
  drawPlane(figure, in.E, out.coefficients, {foot});
  figure.marks.push_back(PointMark{{"Q", Role::Given, Subject::Point, "Q"}, q});
  if (!out.atP0)
    figure.marks.push_back(ArrowMark{{"w", Role::Derived, Subject::Point, "\\vec w"}, p0, q - p0});
  if (!hasPlane)
    return figure;
  if (!out.atP0)
    figure.marks.push_back(
        ArcMark{{"theta", Role::Derived, Subject::Neutral, "\\theta"}, p0, normal, q - p0});
  figure.marks.push_back(PointMark{{"F", Role::Result, Subject::Measure, "F"}, foot});
  if (out.measured.which == PointPlaneCase::On)
    return figure;
  Formula f;
  const std::string distance = f(out.measured.signedDistance);
  figure.marks.push_back(SegmentMark{
      {"distance", Role::Result, Subject::Measure, "\\operatorname{dist} " + f.equals(distance)}, foot, q});
  figure.marks.push_back(
      RightAngleMark{{"F-angle", Role::Helper, Subject::Measure, ""}, foot, q - foot, p0 - foot});
  return figure;
}

} // namespace

Construction signed_distance() {
  return makeConstruction<In, Out>("signed-distance", compute, tell, list, explain, draw,
                                   TypedRole<In, PlaneObject>{"E", &In::E},
                                   TypedRole<In, PointObject>{"Q", &In::Q});
}

} // namespace halfspace
