// Where a ray meets a plane, by substitution and by dot products (notes PG 4 and 5; facing normal: note RP
// 28).
#include "geometry/case_names.h"
#include "geometry/intersect_ray_plane.h"
#include "geometry/project_vector.h"
#include "lessons/construction/construction.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/letters.h"
#include "lessons/term/rewrite.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<PlaneObject> E;
  Given<RayObject> L;
};

struct Out : Naming, PlaneTerms, RayTerms {
  RayPlane<Rational> meet;
  Term d, f, t, H;
  Term facing;      ///< the unit normal towards where the ray comes from, where it crosses the plane
  Term numerator;   ///< of t: (P0 − Q)·n
  Term denominator; ///< r·n
};

Out compute(const In &in) {
  const PlaneTerms E = termsOf(in.E);
  const RayTerms L = termsOf(in.L);
  const auto &[point, normal] = in.E.object;
  const auto &[origin, direction] = in.L.object;
  const auto plane = planeThrough(point, normal);
  const auto meet = intersectRayPlane(Ray<Rational>{origin, direction}, plane);
  std::vector<Surd> facing;
  if (meet.crosses())
    for (const Surd &coordinate : facingNormal(normal, direction))
      facing.push_back(coordinate);
  return {in,
          E,
          L,
          meet,
          name(in.own(letter("d")), plane.offset).standingFor(-dot(E.n, E.P0)),
          applied(in.own(letter("f")), L.Q, evaluate(plane, origin)).standingFor(dot(E.n, L.Q - E.P0)),
          name(in.own(letter("t")), meet.t),
          madeName(in, "H", meet.point),
          name(in.own(vectorLetter("n", "f")), facing).marked(in.mark("facing")),
          dot(E.P0 - L.Q, E.n),
          dot(L.r, E.n)};
}

CaseWords tell(const In &, const Out &at) {
  const std::string t = equation(at.t);
  const std::string caseName(nameOf(at.meet.which));
  switch (at.meet.which) {
  case RayPlaneCase::Hit:
    if (at.meet.t == 0)
      return {caseName, words("t = 0: the ray starts in the plane, so it hits at its own start.")};
    return {caseName, words("{t} is positive: the ray hits the plane.", {{"t", t}})};
  case RayPlaneCase::Behind:
    return {caseName,
            words("{t} is negative: the plane is behind the ray's start, so the ray does not hit it.",
                  {{"t", t}})};
  case RayPlaneCase::Parallel:
    return {
        caseName,
        words(
            "{r}·{n} = 0 but ({P0} − {Q})·{n} is not: the ray runs parallel to the plane and never meets it.",
            at.letters)};
  case RayPlaneCase::InPlane:
    return {caseName,
            words("{r}·{n} = 0 and ({P0} − {Q})·{n} = 0: the ray lies in the plane. Every t fits, so "
                  "0/0 names no single point.",
                  at.letters)};
  case RayPlaneCase::ZeroDirection:
    return zeroDirectionWords(at);
  case RayPlaneCase::ZeroNormal:
    break;
  }
  return zeroNormalWords(at);
}

std::vector<NamedValue> valuesOf(const In &, const Out &at) {
  std::vector<NamedValue> values{listed("numerator", at.numerator), listed("denominator", at.denominator)};
  if (!at.meet.crosses())
    return values;
  values.push_back(listed("t", at.t));
  values.push_back(listed("point", at.H));
  values.push_back(listed("facing_normal", at.facing));
  return values;
}

std::vector<MadeObject> make(const In &, const Out &at) {
  if (!at.meet.crosses())
    return {};
  return {{"H", PointObject{at.meet.point}}};
}

/// The sentence, where there are a plane and a ray that it can speak of; else which of them is missing.
std::string wordsOfBoth(const Out &at, std::string sentence) {
  if (at.meet.which == RayPlaneCase::ZeroNormal)
    return words("{n} is the zero vector: there is no plane.", at.letters);
  if (at.meet.which == RayPlaneCase::ZeroDirection)
    return words("{r} is the zero vector: there is no ray.", at.letters);
  return sentence;
}

WorkingLine substituteLine(const Out &at) {
  const Term inserted = dot(at.n, at.Q + unknown("t") * at.r) + at.d;
  return askedEquation(
      condition((0 == inserted).then(multipliedOut(inserted))),
      wordsOfBoth(at,
                  words("The ray's points {Q} + t·{r} put into the plane's equation. One unknown is left: t.",
                        at.letters)));
}

std::string collectWords(const Out &at) {
  if (at.meet.denominator != 0)
    return words("Collected by t: {r}·{n} stands before t, and f({Q}) is left over.", at.letters);
  return at.meet.numerator == 0
             ? words("{r}·{n} is 0, and so is f({Q}): t drops out, and every t fulfils 0 = 0.", at.letters)
             : words("{r}·{n} is 0: t drops out, and f({Q}) is not 0, so no t fulfils the equation.",
                     at.letters);
}

WorkingLine collectLine(const Out &at) {
  const Term collected = at.denominator * unknown("t") + at.f;
  return askedEquation(condition((0 == collected).then(calculated(collected))), collectWords(at));
}

WorkingLine numeratorLine(const Out &at) {
  return asked(
      withNumbers(at.numerator),
      wordsOfBoth(
          at,
          words("This is −f({Q}). It says how far the plane is from {Q} along {n}, times |{n}|: a distance "
                "only when |{n}| = 1.",
                at.letters)),
      {{at.f, words("{answer} is f({Q}) = {n}·({Q} − {P0}): the numerator goes the other way, from {Q} "
                    "to {P0}.",
                    at.letters)}});
}

WorkingLine denominatorLine(const Out &at) {
  return asked(
      withNumbers(at.denominator),
      wordsOfBoth(at, words("How far one step {r} goes along {n}, times |{n}|. Zero means that no step comes "
                            "nearer to the plane.",
                            at.letters)));
}

WorkingLine parameterLine(const Out &at) {
  return asked(withNumbers(at.t == at.numerator / at.denominator),
               words("So many steps {r} lead from {Q} to the plane. It is a distance only when |{r}| = 1.",
                     at.letters),
               {wrongSignOf(at.t, at)});
}

WorkingLine hitLine(const Out &at) {
  return asked(withNumbers(at.H == at.Q + at.t * at.r),
               at.meet.which == RayPlaneCase::Hit
                   ? words("The point where the ray meets the plane.")
                   : words("Here the line through the ray meets the plane, behind the start: the ray "
                           "itself never gets there."));
}

WorkingLine facingLine(const Out &at) {
  const Term unit = at.n / norm(at.n);
  return at.meet.denominator > 0
             ? asked(
                   withResult(at.facing == -unit),
                   words("{r}·{n} is positive, so {n} points away from where the ray comes from: the facing "
                         "normal is −{n}, made one unit long.",
                         at.letters))
             : asked(
                   withResult(at.facing == unit),
                   words("{r}·{n} is negative, so {n} already points to where the ray comes from: the facing "
                         "normal is {n}, made one unit long.",
                         at.letters));
}

Explanation explain(const In &, const Out &at) {
  Explanation lines;
  lines.add("substitute", [&at] { return substituteLine(at); });
  lines.add("collect", [&at] { return collectLine(at); });
  lines.add("numerator", [&at] { return numeratorLine(at); });
  lines.add("denominator", [&at] { return denominatorLine(at); });
  if (!at.meet.crosses())
    return lines;
  lines.add("t", [&at] { return parameterLine(at); });
  lines.add("hit", [&at] { return hitLine(at); });
  lines.add("facing", [&at] { return facingLine(at); });
  return lines;
}

/// The unit normal is drawn this long in every picture.
constexpr double drawnNormalLength = 1;

Figure draw(const In &in, const Out &at) {
  Figure figure;
  const bool hit = at.meet.which == RayPlaneCase::Hit;
  const Place meeting = place(at.H);
  if (at.meet.which == RayPlaneCase::InPlane)
    figure.reachWithin(in.E.id, in.L.id, place(at.Q), unitOf(in.L.object.direction));
  if (!at.meet.crosses())
    return figure;
  figure.reaches.push_back({in.E.id, meeting});
  if (hit)
    figure.reaches.push_back({in.L.id, meeting});
  else
    figure.add(SegmentMark{{at.H->mark + "/backward", Role::Ghost, Subject::Ray}, place(at.Q), meeting});
  figure.add(pointOf(at.H, hit ? Role::Result : Role::Ghost, Subject::Ray));
  figure.add(ArrowMark{drawn(at.facing, Role::Derived, Subject::Measure), meeting, place(at.facing), false,
                       drawnNormalLength});
  return figure;
}

std::vector<SpecialCase> nearby(const In &in, const Out &at) {
  std::vector<SpecialCase> all;
  const auto &[point, normal] = in.E.object;
  const auto &[origin, direction] = in.L.object;
  if (isZero(normal) || isZero(direction))
    return all;
  const bool crosses = at.meet.crosses();
  const bool startsInPlane = at.meet.numerator == 0;
  if (!startsInPlane) {
    const ExactVec3 foot = origin - projectVector(ExactVec3(origin - point), normal).projection;
    all.push_back(
        {crosses ? "t = 0" : "case = in-plane",
         crosses ? words("{Q} would lie in the plane, and the ray would hit it at its own start.", at.letters)
                 : words("The ray would lie in the plane."),
         "L", RayObject{foot, direction}});
  }
  if (const ExactVec3 turned = projectVector(direction, normal).rejection; crosses && !isZero(turned))
    all.push_back({startsInPlane ? "case = in-plane" : "case = parallel",
                   startsInPlane ? words("The ray would lie in the plane.")
                                 : words("The ray would run parallel to the plane."),
                   "L", RayObject{origin, turned}});
  return all;
}

} // namespace

Construction ray_plane_dot() {
  return makeConstruction<In, Out, PlaneObject, RayObject>(
      "ray-plane-dot", {"E", "L"}, {{"H", "point"}}, {"d", "f", "t", "nf"},
      {.cases = {"hit", "behind", "parallel", "in-plane", "zero-direction", "zero-normal"},
       .values = {named::number("numerator"), named::number("denominator"), named::number("t"),
                  named::vector("point"), named::vector("facing_normal")},
       .lines = {"substitute", "collect", "numerator", "denominator", "t", "hit", "facing"},
       .marks = {"H", "facing"}},
      {compute, tell, valuesOf, make, explain, draw, nearby});
}

} // namespace halfspace
