// How far a point is from a plane, and on which side (notes PG 3.4 and 3.5, figure 1).
#include "geometry/case_names.h"
#include "geometry/point_plane.h"
#include "lessons/construction/construction.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/letters.h"
#include "lessons/term/angle.h"
#include "lessons/term/latex.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<PlaneObject> E;
  Given<PointObject> Q;
};

struct Out : Naming, PlaneTerms {
  PointPlaneCase which;
  ExactVec3 foot;
  bool atP0; ///< w is zero: there is no angle
  Term Q, f, w, dist, F;
  Term theta, cosine; ///< of the angle between n and w, where there is one
};

Out compute(const In &in) {
  const PlaneTerms E = termsOf(in.E);
  const Term Q = termOf(in.Q);
  const auto &[point, normal] = in.E.object;
  const auto measured = measurePointPlane(in.Q.object.at, planeThrough(point, normal));
  const ExactVec3 w = in.Q.object.at - point;
  const bool hasAngle = measured.which != PointPlaneCase::ZeroNormal && !isZero(w);
  const Term theta = name(in.own(letter("θ")), std::nullopt).marked(in.mark("theta"));
  return {in,
          E,
          measured.which,
          measured.foot,
          isZero(w),
          Q,
          applied(in.own(letter("f")), Q, measured.f),
          name(in.own(vectorLetter("w")), w).standingFor(Q - E.P0).marked(in.mark("w")),
          name(in.own(word("dist")), measured.signedDistance).marked(in.mark("distance")),
          madeName(in, "F", measured.foot),
          theta,
          applied(word("cos"), theta,
                  hasAngle ? overRoot(measured.f, Rational(measured.normalSquared * dot(w, w))) : Surd())};
}

CaseWords tell(const In &, const Out &at) {
  const std::string f = equation(at.f);
  const std::string distance = equation(name(word("signed distance"), at.dist->value));
  const std::string caseName(nameOf(at.which));
  switch (at.which) {
  case PointPlaneCase::Positive:
    return {caseName, words("{f} is positive: {Q} lies on the side that {n} points to, {distance}.",
                            at.letters, {{"f", f}, {"distance", distance}})};
  case PointPlaneCase::Negative:
    return {caseName, words("{f} is negative: {Q} lies on the side that {n} points away from, {distance}.",
                            at.letters, {{"f", f}, {"distance", distance}})};
  case PointPlaneCase::On:
    return {caseName, words("f({Q}) = 0: {Q} lies in the plane.", at.letters)};
  case PointPlaneCase::ZeroNormal:
    break;
  }
  return zeroNormalWords(at);
}

std::vector<NamedValue> valuesOf(const In &, const Out &at) {
  std::vector<NamedValue> values{listed("f", at.f)};
  if (at.which == PointPlaneCase::ZeroNormal)
    return values;
  values.push_back(listed("signed_distance", at.dist));
  values.push_back({"side", words("side"), std::string(nameOf(at.which))});
  values.push_back(listed("foot", at.F));
  if (!at.atP0)
    values.push_back(listed("cos_angle", at.cosine));
  return values;
}

std::vector<MadeObject> make(const In &, const Out &at) {
  if (at.which == PointPlaneCase::ZeroNormal)
    return {};
  return {{"F", PointObject{at.foot}}};
}

std::string sideWords(const Out &at) {
  switch (at.which) {
  case PointPlaneCase::Positive:
    return words("The sign tells the side: positive where {n} points.", at.letters);
  case PointPlaneCase::Negative:
    return words("The sign tells the side: negative on the side that {n} points away from.", at.letters);
  default:
    return words("Zero: {Q} satisfies the plane's equation, so it lies in the plane.", at.letters);
  }
}

std::string distanceWords(const Out &at) {
  if (at.which == PointPlaneCase::On)
    return words("f({Q}) is 0, and so is the distance: 0 divided by any length is 0.", at.letters);
  if (isUnit(at.n))
    return words("Because |{n}| = 1, f({Q}) is the signed distance already.", at.letters);
  return words("{f} is not the distance: {n} is {length} long, so f({Q}) is {length} times the distance.",
               at.letters, {{"f", equation(at.f)}, {"length", plainText(calculated(norm(at.n)))}});
}

WorkingLine distanceLine(const Out &at) {
  const auto &letters = at.letters;
  return asked(
      withNumbers(at.dist == at.f / norm(at.n)), distanceWords(at),
      {{at.f, words("{answer} is f({Q}): {n} is not normalized, so divide by |{n}|.", letters)},
       {-at.dist, words("{answer} has the wrong sign: the distance has the sign of f({Q}).", letters)},
       {norm(at.f), words("{answer} is f({Q}) without its sign, and not divided by |{n}| either.", letters)},
       {at.f / dot(at.n, at.n),
        words("{answer} is f({Q})/({n}·{n}): divide by the root of {n}·{n}, |{n}|.", letters)}});
}

WorkingLine cosineLine(const Out &at) {
  return asked(
      withNumbers(at.cosine == dot(at.n, at.w) / (norm(at.n) * norm(at.w))),
      words("θ{degrees}° is the angle between {n} and w = {Q} − {P0}. So dist = |w| cos θ is the part "
            "of w that runs along {n}.",
            at.letters, {{"degrees", relatedText(degreesOf(at.cosine))}}),
      {{at.dist, words("{answer} is the distance: divide by |w| as well.")},
       {dot(at.n, at.w), words("{answer} is {n}·w: divide by both lengths.", at.letters)}});
}

WorkingLine valueLine(const Out &at) {
  return asked(withNumbers(at.f == dot(at.n, at.Q - at.P0)),
               at.which == PointPlaneCase::ZeroNormal
                   ? words("Zero, because {n} is the zero vector: there is no plane.", at.letters)
                   : words("Zero in the plane, positive on the side that {n} points to.", at.letters),
               {{dot(at.n, at.Q),
                 words("{answer} is {n}·{Q}: {P0} is to be subtracted from {Q} first.", at.letters)}});
}

WorkingLine lengthLine(const Out &at) {
  return asked(withProducts(norm(at.n) == root(dot(at.n, at.n))), words("The length of the normal."),
               {{dot(at.n, at.n), words("{answer} is {n}·{n}: its root is still to be taken.", at.letters)}});
}

WorkingLine footLine(const Out &at) {
  return asked(withNumbers(at.F == at.Q - at.f / dot(at.n, at.n) * at.n),
               words("The foot: from {Q} straight along {n} to the plane, its nearest point.", at.letters));
}

Explanation explain(const In &, const Out &at) {
  Explanation lines;
  lines.add("f", [&at] { return valueLine(at); });
  if (at.which == PointPlaneCase::ZeroNormal)
    return lines;
  lines.add("side", [&at] { return line(compared(at.f, 0), sideWords(at)); });
  lines.add("length", [&at] { return lengthLine(at); });
  lines.add("distance", [&at] { return distanceLine(at); });
  if (!at.atP0)
    lines.add("cosine", [&at] { return cosineLine(at); });
  lines.add("foot", [&at] { return footLine(at); });
  return lines;
}

/// The angle between n and w, with the corner of a right one.
void drawAngle(Figure &figure, const Out &at, const Place &corner, const Place &way) {
  MarkBase angle = drawn(at.theta, Role::Derived, Subject::Neutral);
  const Place normal = place(at.n);
  if (at.which == PointPlaneCase::On)
    figure.add(RightAngleMark{std::move(angle), corner, normal, way});
  else
    figure.add(ArcMark{std::move(angle), corner, normal, way});
}

Figure draw(const In &in, const Out &at) {
  Figure figure;
  const Place q = place(at.Q);
  const Place p0 = place(at.P0);
  const bool hasPlane = at.which != PointPlaneCase::ZeroNormal;
  const Place foot = hasPlane ? place(at.F) : p0;
  figure.reaches.push_back({in.E.id, foot});
  if (!at.atP0)
    figure.add(arrowOf(at.w, p0, Role::Derived, Subject::Point));
  if (!hasPlane)
    return figure;
  if (!at.atP0)
    drawAngle(figure, at, p0, q - p0);
  figure.add(pointOf(at.F, Role::Result, Subject::Measure));
  if (at.which == PointPlaneCase::On)
    return figure;
  MarkBase distance = drawn(at.dist, Role::Result, Subject::Measure);
  distance.numbers = relatedLatex(calculated(at.dist));
  figure.add(SegmentMark{std::move(distance), foot, q});
  figure.add(
      RightAngleMark{{at.F->mark + "/angle", Role::Helper, Subject::Measure}, foot, q - foot, p0 - foot});
  return figure;
}

std::vector<SpecialCase> nearby(const In &, const Out &at) {
  if (at.which == PointPlaneCase::ZeroNormal || at.which == PointPlaneCase::On)
    return {};
  return {{"side = on", words("{Q} would lie in the plane.", at.letters), "Q", PointObject{at.foot}}};
}

} // namespace

Construction signed_distance() {
  return makeConstruction<In, Out, PlaneObject, PointObject>(
      "signed-distance", {"E", "Q"}, {{"F", "point"}}, {"f", "w", "dist", "θ"},
      {.cases = {"positive", "negative", "on", "zero-normal"},
       .values = {named::number("f"), named::number("signed_distance"),
                  named::word("side", {"positive", "negative", "on"}), named::vector("foot"),
                  named::number("cos_angle")},
       .lines = {"f", "side", "length", "distance", "cosine", "foot"},
       .marks = {"w", "theta", "F", "distance"}},
      {compute, tell, valuesOf, make, explain, draw, nearby});
}

} // namespace halfspace
