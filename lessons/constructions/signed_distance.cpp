// How far a point is from a plane, and on which side (notes PG 3.4 and 3.5, figure 1).
#include "geometry/point_plane.h"
#include "lessons/construction.h"
#include "lessons/drawing.h"
#include "lessons/given.h"
#include "lessons/term/latex.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "lessons/term/written.h"
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
  PointPlane<Rational> measured; // f, signed distance, foot
  ExactVec3 w;                   // Q − P0
  bool atP0 = false;             // w is zero: there is no angle
  Surd cosine;                   // of the angle θ between n and w
};

Out compute(const In &in) {
  Out out;
  out.measured = measurePointPlane(in.Q.at, planeThrough(in.E.point, in.E.normal));
  out.w = in.Q.at - in.E.point;
  out.atP0 = isZero(out.w);
  if (out.measured.which != PointPlaneCase::ZeroNormal && !out.atP0)
    out.cosine = overRoot(out.measured.f, Rational(out.measured.normalSquared * dot(out.w, out.w)));
  return out;
}

/// The letters of the lines.
struct Letters : PlaneTerms {
  Term Q, f, w, dist, cosine, F;
};

Letters lettersOf(const In &in, const Out &out) {
  const PlaneTerms E = termsOf(in.E, "E");
  const Term Q = termOf(in.Q, "Q");
  const Term theta = name(letter("θ"), std::nullopt).marked("theta");
  return {E,
          Q,
          applied(letter("f"), Q, out.measured.f),
          name(vectorLetter("w"), out.w).standingFor(Q - E.P0).marked("w"),
          name(word("dist"), out.measured.signedDistance).marked("distance"),
          applied(word("cos"), theta, out.cosine),
          name(letter("F"), out.measured.foot).marked("F")};
}

CaseWords tell(const In &in, const Out &out) {
  const std::string f = equation(lettersOf(in, out).f);
  const std::string distance = equation(name(word("signed distance"), out.measured.signedDistance));
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

std::vector<NamedValue> list(const In &in, const Out &out) {
  const Letters at = lettersOf(in, out);
  std::vector<NamedValue> values{listed("f", at.f)};
  if (out.measured.which == PointPlaneCase::ZeroNormal)
    return values;
  values.push_back(listed("signed_distance", at.dist));
  values.push_back({"side", words("side"), sideName(out.measured.which)});
  values.push_back(listed("foot", at.F));
  if (!out.atP0)
    values.push_back(listed("cos_angle", at.cosine));
  return values;
}

std::string sideWords(PointPlaneCase which) {
  switch (which) {
  case PointPlaneCase::Positive:
    return words("The sign tells the side: positive where n points.");
  case PointPlaneCase::Negative:
    return words("The sign tells the side: negative behind the plane, seen along n.");
  default:
    return words("Zero: Q satisfies the plane's equation, so it lies in the plane.");
  }
}

std::string distanceWords(const Letters &at, const Out &out) {
  if (out.measured.normalSquared == 1)
    return words("Because |n| = 1, f(Q) is the signed distance already.");
  return words("{f} is not the distance: n is {length} long, so f(Q) is so many times as large.",
               {{"f", equation(at.f)}, {"length", plainText(calculated(norm(at.n)))}});
}

WorkingLine distanceLine(const Letters &at, const Out &out) {
  return asked(line("distance", {withNumbers(at.dist == at.f / norm(at.n))}, distanceWords(at, out)),
               {{at.f, words("{answer} is f(Q): n is not normalized, so divide by |n|.")},
                {norm(at.f), words("{answer} is f(Q) without its sign, and not divided by |n| either.")},
                {at.f / dot(at.n, at.n), words("{answer} is f(Q)/(n·n): divide by the root of n·n, |n|.")},
                {-at.dist, words("{answer} has the wrong sign: the distance has the sign of f(Q).")}});
}

WorkingLine cosineLine(const Letters &at, const Out &out) {
  const double degrees = std::acos(std::clamp(toDouble(out.cosine), -1.0, 1.0)) * 180 / std::numbers::pi;
  return asked(line("cosine", {withNumbers(at.cosine == dot(at.n, at.w) / (norm(at.n) * norm(at.w)))},
                    words("θ ≈ {degrees}° is the angle between n and w = Q − P₀. So dist = |w| cos θ is the "
                          "part of w that runs along n.",
                          {{"degrees", plainText(rounded(degrees))}})),
               {{at.dist, words("{answer} is the distance: divide by |w| as well.")},
                {dot(at.n, at.w), words("{answer} is n·w: divide by both lengths.")}});
}

Working explain(const In &in, const Out &out) {
  const Letters at = lettersOf(in, out);
  Working working{
      {asked(line("f", {withNumbers(at.f == dot(at.n, at.Q - at.P0))},
                  words("Q put into the left side of the plane's equation.")),
             {{dot(at.n, at.Q), words("{answer} is n·Q: P₀ is to be subtracted from Q first.")}})}};
  if (out.measured.which == PointPlaneCase::ZeroNormal)
    return working;
  working.lines.push_back(line("side", {compared(at.f, 0)}, sideWords(out.measured.which)));
  working.lines.push_back(asked(
      line("length", {withProducts(norm(at.n) == root(dot(at.n, at.n)))}, words("The length of the normal.")),
      {{dot(at.n, at.n), words("{answer} is n·n: its root is still to be taken.")}}));
  working.lines.push_back(distanceLine(at, out));
  if (!out.atP0)
    working.lines.push_back(cosineLine(at, out));
  working.lines.push_back(
      asked(line("foot", {withNumbers(at.F == at.Q - at.f / dot(at.n, at.n) * at.n)},
                 words("The foot: from Q straight along n to the plane, its nearest point."))));
  return working;
}

Figure draw(const In &in, const Out &out) {
  Figure figure;
  const Place q = place(in.Q.at);
  const Place p0 = place(in.E.point);
  const Place normal = place(in.E.normal);
  const bool hasPlane = out.measured.which != PointPlaneCase::ZeroNormal;
  const Place foot = hasPlane ? place(out.measured.foot) : p0;
  drawPlane(figure, in.E, {foot});
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
  const Term dist = name(word("dist"), out.measured.signedDistance);
  figure.marks.push_back(SegmentMark{
      {"distance", Role::Result, Subject::Measure, latexOf(dist), relatedLatex(calculated(dist))}, foot, q});
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
