// What all constructions of a ray and a triangle tell alike: where a point of the plane lies, what is no
// triangle, and the special cases nearby. Their roles are called T and L, and the ray's parameter t.
#pragma once

#include "geometry/intersect_ray_triangle.h"
#include "lessons/construction/naming.h"
#include "lessons/construction/outcome.h"
#include "lessons/construction/parts/place_rows.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/triangle.h"

namespace halfspace {

struct RayAndTriangle : Naming {
  Given<TriangleObject> T;
  Given<RayObject> L;
};

/// What the Out of such a construction begins with.
struct RayAtTriangle : Computed<RayAndTriangle>, TriangleTerms, RayTerms {
  explicit RayAtTriangle(const RayAndTriangle &objects)
      : Computed(objects), TriangleTerms(termsOf(objects.T)), RayTerms(termsOf(objects.L)) {}

  Ray<Rational> ray{in.L.object.origin, in.L.object.direction};
  Triangle<Rational> triangle{in.T.object.p0, in.T.object.p1, in.T.object.p2};
};

/// The same where the perps tell how they meet.
struct RayByPerps : RayAtTriangle {
  using RayAtTriangle::RayAtTriangle;

  RayTriangle<Rational> meet = intersectRayTriangle(ray, triangle);
  const TrianglePerps<Rational> &perps = meet.perps;
  bool crosses = meet.crosses();
  bool isTriangle = perps.denominator != 0;

  Term u = drawnName(vectorLetter("u"), perps.u);
  Term v = drawnName(vectorLetter("v"), perps.v);
  Term n = drawnName(vectorLetter("n"), perps.normal);
  Term uPerp = ownName(perpLetter("u"), perps.uPerp).marked(mark("uperp"));
  Term s = ownName(letter("s"), meet.s);
  Term t = ownName(letter("t"), meet.tTriangle);
  Term lambda = ownName(letter("λ"), meet.plane.t);
  Term I = madeName("I", meet.plane.point);
};

/// The values of the point I in which the ray's line crosses the plane, at λ.
template <class Out> [[nodiscard]] ValueTable<Out> crossingRows(PlaceIn<Out> place) {
  return joined<ValueRow<Out>>({placeRows<Out>(&Out::crosses, place),
                                {{named::number("t"), &Out::crosses, &Out::lambda},
                                 {named::vector("point"), &Out::crosses, &Out::I}}});
}

/// How much of the sides u and v leads to it.
template <class Out> [[nodiscard]] ValueTable<Out> shareRows() {
  return {{named::number("s"), &Out::crosses, &Out::s},
          {named::number("t_triangle"), &Out::crosses, &Out::t}};
}

/// How much of each corner is in it, by how much of the two sides is.
template <class Out>
[[nodiscard]] ValueRow<Out> barycentricRow(When<Out> stands, Term Out::*s, Term Out::*t) {
  return {named::list("barycentric", 3), std::move(stands), [s, t](const Out &at) {
            return list({1 - at.*s - at.*t, at.*s, at.*t});
          }};
}

/// The determinants of Cramer's rule.
template <class Out> [[nodiscard]] ValueRow<Out> cramerRow() {
  return valueGroup<Out>("cramer", always,
                         {{named::number("det"), always, &Out::D},
                          {named::number("det_sigma"), always, &Out::D1},
                          {named::number("det_tau"), always, &Out::D2},
                          {named::number("det_t"), always, &Out::D3}});
}

/// The lines of the sides u and v.
template <class Out> [[nodiscard]] LineTable<Out> sideLines() {
  return {{"u", always, [](const Out &at) { return asked(withNumbers(at.u == at.P1 - at.P0)); }},
          {"v", always, [](const Out &at) { return withNumbers(at.v == at.P2 - at.P0); },
           says("Two sides of the triangle, both from {P0}.")}};
}

/// The line of their cross product.
[[nodiscard]] WorkingLine sidesNormalLine(const Term &n, const Term &u, const Term &v, std::string sentence);

/// The sentence for where a point is in the triangle's plane: it names an edge as {edge}, a corner as
/// {corner}, and has the values in its other places.
[[nodiscard]] std::string placeWords(const FaceLocation &location, const TriangleTerms &corners,
                                     const PlaceSentences &sentences, WordValues values = {});

/// Of a hit, at {lambda}.
inline constexpr PlaceSentences hitSentences{says("The ray hits inside the triangle, at {lambda}."),
                                             says("The ray hits on the edge {edge}, at {lambda}."),
                                             says("The ray hits at the corner {corner}, at {lambda}.")};

/// Sentences for corners that are one point: two of them, {first} and {second}, or all, with {third}.
struct CoincidentSentences {
  Sentence two;
  Sentence three;
};
/// The one for a triangle with such corners.
[[nodiscard]] std::string coincidentWords(const TriangleObject &triangle, const TriangleTerms &corners,
                                          const CoincidentSentences &sentences);

/// Two corners that are one point, for a triangle with such.
[[nodiscard]] std::pair<Term, Term> coincidentCorners(const TriangleObject &triangle,
                                                      const TriangleTerms &corners);

/// The cosine of the angle between a triangle's sides u and v; 0 where there is none.
[[nodiscard]] Surd cosineOf(const TrianglePerps<Rational> &perps);

/// Adds the triangles with one corner moved onto the line of the two others.
void addFlattened(const TriangleObject &triangle, const Naming &naming, std::vector<SpecialCase> &all);

/// The arrow from P₀ to where the ray meets the triangle's plane, in a hue that no other part has.
[[nodiscard]] ArrowMark wayToHit(const Term &w, const Place &p0);

/// The special cases near a ray and a triangle, by the values that the eval format has for them.
[[nodiscard]] std::vector<SpecialCase> rayTriangleNearby(const RayAtTriangle &at);

} // namespace halfspace
