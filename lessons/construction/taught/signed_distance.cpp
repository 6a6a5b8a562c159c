// How far a point is from a plane, and on which side (notes PG 3.4 and 3.5, figure 1).
#include "geometry/angle.h"
#include "geometry/case_names.h"
#include "lessons/construction/parts/point_at_plane.h"
#include "lessons/construction/parts/value_words.h"
#include "lessons/construction/taught.h"
#include "lessons/object/flat.h"
#include "lessons/term/angle.h"

#include <algorithm>

namespace halfspace {
namespace {

struct Out : MeasuredPoint {
  explicit Out(const PointAtPlane &objects) : MeasuredPoint(objects) {}

  ExactVec3 way = in.Q.object.at - in.E.object.point;
  bool hasAngle = hasPlane && !isZero(way);
  /// How many times n leads from the plane to the height of the point.
  Rational steps = hasPlane ? Rational(measured.f / measured.normalSquared) : Rational(0);

  Term w = drawnName(vectorLetter("w"), way).standingFor(Q - P0);
  /// As high as Q on the gauge, which stands on P0 along n.
  Term M = drawnName(letter("M"), ExactVec3(in.E.object.point + in.E.object.normal * steps));
  Term theta = ownName(letter("θ"), std::nullopt).marked(mark("theta"));
  Term cosine = applied(word("cos"), theta, cosineBetween(in.E.object.normal, way));
};

CaseWords tell(const Out &at) {
  const std::string f = equation(at.f);
  const std::string distance = equation(name(word(words("signed distance")), at.dist->value));
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

WorkingLine sideLine(const Out &at) { return line(compared(at.f, 0), sideWords(at)); }

WorkingLine cosineLine(const Out &at) {
  return asked(
      withNumbers(at.cosine == dot(at.n, at.w) / (norm(at.n) * norm(at.w))),
      words("θ{degrees}° is the angle between {n} and w = {Q} − {P0}. So dist = |w| cos θ is the part "
            "of w that runs along {n}.",
            at.letters, {{"degrees", relatedText(degreesOf(at.cosine))}}),
      {{at.dist, words("{answer} is the distance: divide by |w| as well.")},
       {dot(at.n, at.w), words("{answer} is {n}·w: divide by both lengths.", at.letters)}});
}

/// Whether one unit along the x-axis leads the point nearer to the plane.
ToldValue alongXValue(const Out &at) {
  const Rational before = abs(at.measured.f);
  const Rational after = abs(Rational(at.measured.f + at.in.E.object.normal.x));
  return {words("distance after one unit along x"), after < before   ? Word{"nearer", words("smaller")}
                                                    : after > before ? Word{"farther", words("larger")}
                                                                     : Word{"same", words("the same")}};
}

WorkingLine gaugeLine(const Out &at) {
  return asked(withNumbers(at.M == at.P0 + at.f / dot(at.n, at.n) * at.n),
               words("Straight across from {Q}, on the line through {P0} along {n}.", at.letters));
}

/// f of the mark on the gauge.
WorkingLine levelLine(const Out &at) {
  return asked(
      withNumbers(dot(at.n, at.M - at.P0)),
      words("f of M: the same as f of {Q}, because parallel to the plane f stays the same.", at.letters));
}

WorkingLine lengthLine(const Out &at) {
  return asked(withProducts(norm(at.n) == root(dot(at.n, at.n))), words("The length of the normal."),
               {{dot(at.n, at.n), words("{answer} is {n}·{n}: its root is still to be taken.", at.letters)}});
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

// The gauge has a line at 0, n·n, 2 n·n …, or only at each second, fifth, tenth … of them: not more than
// these can be told apart.
constexpr int mostDivisions = 8;
constexpr double divisionLength = 0.35; ///< in scene units, to both sides

/// How many steps lead from one line of the gauge to the next: 1, 2, 5, 10, 20 …
Rational strideOf(const Rational &divisions) {
  Rational decade = 1;
  for (;; decade *= 10)
    for (const int factor : {1, 2, 5})
      if (divisions <= decade * factor * mostDivisions)
        return decade * factor;
}

/// Where f can be read off: through P0 along n, at least one step to both sides of it, and past M.
void drawGauge(Figure &figure, const Out &at) {
  const Rational low = std::min(floorOf(at.steps), Rational(-1));
  const Rational high = std::max(Rational(floorOf(at.steps) + 1), Rational(1));
  const Rational stride = strideOf(high - low);
  const Place across = unitOf(anyPerpendicular(at.in.E.object.normal)) * divisionLength;
  const auto heightAt = [&](const Rational &steps) {
    return place(ExactVec3(at.in.E.object.point + at.in.E.object.normal * steps));
  };
  figure.add(
      SegmentMark{{at.M->mark + "/gauge", Role::Derived, Subject::Plane}, heightAt(low), heightAt(high)});
  for (Rational step = floorOf(low / stride) * stride; step <= high; step += stride) {
    if (step < low)
      continue;
    const Place middle = heightAt(step);
    const Term value(Rational(step * at.measured.normalSquared));
    figure.add(SegmentMark{{at.M->mark + "/at" + toText(step), Role::Derived, Subject::Plane, latexOf(value)},
                           middle - across,
                           middle + across});
  }
  figure.add(pointOf(at.M, Role::Result, Subject::Point));
  if (vectorOf(at.M) != vectorOf(at.Q))
    figure.add(SegmentMark{{at.M->mark + "/way", Role::Helper, Subject::Point}, place(at.M), place(at.Q)});
}

Figure draw(const Out &at) {
  Figure figure;
  const Place q = place(at.Q);
  const Place p0 = place(at.P0);
  figure.reaches.push_back({at.in.E.id, at.hasPlane ? place(at.F) : p0});
  if (!isZero(at.way))
    figure.add(arrowOf(at.w, p0, Role::Derived, Subject::Point));
  if (!at.hasPlane)
    return figure;
  if (at.hasAngle)
    drawAngle(figure, at, p0, q - p0);
  figure.add(pointOf(at.F, Role::Result, Subject::Measure));
  drawGauge(figure, at);
  if (at.which == PointPlaneCase::On)
    return figure;
  drawDistance(figure, at);
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  if (!at.hasPlane || at.which == PointPlaneCase::On)
    return {};
  return {{is("side", "on"), words("{Q} would lie in the plane.", at.letters), "Q",
           PointObject{at.measured.foot}}};
}

} // namespace

Construction signed_distance() {
  return taught<Out, PlaneObject, PointObject>(
      {.id = "signed-distance",
       .word = "distance",
       .title = [] { return words("signed distance from the plane"); },
       .roles = {"E", "Q"},
       .makes = {{"F", &Out::hasPlane, &Out::F}},
       .letters = {"f", "w", "dist", "θ", "M"},
       .cases = {"positive", "negative", "on", "zero-normal"},
       .values = {{named::number("f"), always, &Out::f},
                  {named::number("signed_distance"), &Out::hasPlane, &Out::dist},
                  {named::word("side", {"positive", "negative", "on"}), &Out::hasPlane,
                   [](const Out &at) { return ToldValue(words("side"), wordOf(at.which)); }},
                  {named::word("along_x", {"nearer", "farther", "same"}), &Out::hasPlane, alongXValue},
                  {named::number("steps"), &Out::hasPlane,
                   [](const Out &at) {
                     return ToldValue(words("steps {n} up to {Q}", at.letters), Surd(at.steps));
                   }},
                  {named::vector("foot"), &Out::hasPlane, &Out::F},
                  {named::number("cos_angle"), &Out::hasAngle, &Out::cosine}},
       .lines = {{"f", always, valueLine},
                 {"side", &Out::hasPlane, sideLine},
                 {"gauge", &Out::hasPlane, gaugeLine},
                 {"level", &Out::hasPlane, levelLine},
                 {"length", &Out::hasPlane, lengthLine},
                 {"distance", &Out::hasPlane, distanceLine},
                 {"cosine", &Out::hasAngle, cosineLine},
                 {"foot", &Out::hasPlane, footLine}},
       .marks = {"w", "theta", "F", "M", "distance"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
