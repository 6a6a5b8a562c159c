// What all constructions of a ray and a triangle tell alike: where a point of the plane lies, what is no
// triangle, and the special cases nearby. Their roles are called T and L, and the ray's parameter t.
#pragma once

#include "geometry/intersect_ray_triangle.h"
#include "lessons/construction/naming.h"
#include "lessons/construction/outcome.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/triangle.h"

namespace halfspace {

/// Where a point is in the triangle's plane, for people: inside the triangle, on the edge P₀P₁ …
[[nodiscard]] std::string placeWords(const FaceLocation &location, const TriangleTerms &corners);

/// Which corners are one point, for people: P₀ and P₁ are the same point. Requires a triangle with such
/// corners.
[[nodiscard]] std::string coincidentWords(const TriangleObject &triangle, const TriangleTerms &corners);

/// Adds the triangles with one corner moved onto the line of the two others.
void addFlattened(const TriangleObject &triangle, const Naming &naming, std::vector<SpecialCase> &all);

/// The arrow from P₀ to where the ray meets the triangle's plane, in a hue that no other part has.
[[nodiscard]] ArrowMark wayToHit(const Term &w, const Place &p0);

/// The special cases near a ray and a triangle, by the values that the eval format has for them.
[[nodiscard]] std::vector<SpecialCase> rayTriangleNearby(const TriangleObject &triangle, const RayObject &ray,
                                                         const TriangleTerms &corners, const Naming &naming);

} // namespace halfspace
