// Where a ray meets a plane, by substitution and by dot products (notes PG 4 and 5; facing normal: note RP
// 28).
#include "geometry/intersect_ray_plane.h"
#include "lessons/construction.h"
#include "lessons/drawing.h"
#include "lessons/given.h"
#include "lessons/term/rewrite.h"
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
  Rational f;               // f(Q), the constant left after substitution
  RayPlane<Rational> meet;  // numerator, denominator, t, point
  std::vector<Surd> facing; // the facing normal, where the ray's line crosses the plane
};

Out compute(const In &in) {
  Out out;
  out.plane = planeThrough(in.E.point, in.E.normal);
  out.f = evaluate(out.plane, in.L.origin);
  out.meet = intersectRayPlane(Ray<Rational>{in.L.origin, in.L.direction}, out.plane);
  if (!out.meet.crosses())
    return out;
  const auto facing = facingNormal(in.E.normal, in.L.direction);
  out.facing.assign(facing.begin(), facing.end());
  return out;
}

/// The letters of the lines.
struct Letters : PlaneTerms, RayTerms {
  Term d, f, t, H, facing;
  Term numerator;   ///< of t: (P0 − Q)·n
  Term denominator; ///< r·n
};

Letters lettersOf(const In &in, const Out &out) {
  const PlaneTerms E = termsOf(in.E, "E");
  const RayTerms L = termsOf(in.L, "L");
  return {E,
          L,
          name(letter("d"), out.plane.offset).standingFor(-dot(E.n, E.P0)),
          applied(letter("f"), L.Q, out.f).standingFor(dot(E.n, L.Q - E.P0)),
          name(letter("t"), out.meet.t),
          name(letter("H"), out.meet.point).marked("H"),
          name(vectorLetter("n", "f"), out.facing).marked("facing"),
          dot(E.P0 - L.Q, E.n),
          dot(L.r, E.n)};
}

CaseWords tell(const In &in, const Out &out) {
  const std::string t = equation(lettersOf(in, out).t);
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

std::vector<NamedValue> list(const In &in, const Out &out) {
  const Letters at = lettersOf(in, out);
  std::vector<NamedValue> values{listed("numerator", at.numerator), listed("denominator", at.denominator)};
  if (!out.meet.crosses())
    return values;
  values.push_back(listed("t", at.t));
  values.push_back(listed("point", at.H));
  values.push_back(listed("facing_normal", at.facing));
  return values;
}

WorkingLine substituteLine(const Letters &at) {
  const Term inserted = dot(at.n, at.Q + unknown("t") * at.r) + at.d;
  return line("substitute", {condition((0 == inserted).then(multipliedOut(inserted)))},
              words("The ray's points Q + t·r put into the plane's equation. One unknown is left: t."));
}

WorkingLine collectLine(const Letters &at) {
  const Term equation = at.denominator * unknown("t") + at.f;
  return line("collect", {condition((0 == equation).then(calculated(equation)))},
              words("Collected by t: r·n stands before t, and f(Q) is left over."));
}

WorkingLine numeratorLine(const Letters &at) {
  return asked(
      line("numerator", {withNumbers(at.numerator)},
           words("The same by dot products. The numerator is −f(Q): how far the plane is from Q, "
                 "measured along n.")),
      {{at.f, words("{answer} is f(Q) = n·(Q − P₀): the numerator goes the other way, from Q to P₀.")}});
}

WorkingLine denominatorLine(const Letters &at) {
  return asked(line("denominator", {withNumbers(at.denominator)},
                    words("The denominator: how far one step r goes along n. Zero means that no step along r "
                          "comes nearer to the plane.")));
}

WorkingLine tLine(const Letters &at) {
  return asked(line("t", {withNumbers(at.t == at.numerator / at.denominator)},
                    words("So many steps r lead from Q to the plane. It is a distance only when |r| = 1.")),
               {wrongSignOf(at.t)});
}

WorkingLine hitLine(const Letters &at, const Out &out) {
  return asked(line("hit", {withNumbers(at.H == at.Q + at.t * at.r)},
                    out.meet.which == RayPlaneCase::Hit
                        ? words("The point where the ray meets the plane.")
                        : words("Here the line through the ray meets the plane, behind the start: the ray "
                                "itself never gets there.")));
}

WorkingLine facingLine(const Letters &at, const Out &out) {
  const Term unit = at.n / norm(at.n);
  const bool flipped = out.meet.denominator > 0;
  return asked(
      line("facing", {withResult(at.facing == (flipped ? -unit : unit))},
           flipped ? words("r·n is positive, so n points away from where the ray comes from: the facing "
                           "normal is −n, made one unit long.")
                   : words("r·n is negative, so n already points to where the ray comes from: the facing "
                           "normal is n, made one unit long.")));
}

Working explain(const In &in, const Out &out) {
  const Letters at = lettersOf(in, out);
  Working working{{substituteLine(at), collectLine(at), numeratorLine(at), denominatorLine(at)}};
  if (out.meet.crosses())
    for (WorkingLine &line : std::vector<WorkingLine>{tLine(at), hitLine(at, out), facingLine(at, out)})
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
  drawPlane(figure, in.E, crosses ? std::vector{meeting} : std::vector<Place>{});
  drawRay(figure, in.L, hit ? std::optional(meeting) : std::nullopt);
  if (!crosses)
    return figure;
  if (!hit)
    figure.marks.push_back(SegmentMark{{"H-backward", Role::Ghost, Subject::Ray, ""}, q, meeting});
  figure.marks.push_back(PointMark{{"H", hit ? Role::Result : Role::Ghost, Subject::Ray, "H"}, meeting});
  const auto &unit = out.facing;
  figure.marks.push_back(ArrowMark{{"facing", Role::Derived, Subject::Measure, "\\vec n_f"},
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
