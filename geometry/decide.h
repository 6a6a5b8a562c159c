// Verdicts on doubles that are always right.
#pragma once

#include "geometry/intersect_ray_plane.h"
#include "geometry/intersect_ray_sphere.h"
#include "geometry/intersect_ray_triangle.h"
#include "geometry/point_plane.h"

#include <optional>

namespace halfspace {

// Each of these takes doubles for exactly the numbers that they are, and requires finite ones.
// (1) decide…(x) is the verdict of the query of the same name on exactly(x), for every x.
// A filter decides nearly all inputs in plain arithmetic, with a bound on its error; where the bound leaves a
// sign open, exact arithmetic decides.

/// The side of a point, as of `measurePointPlane`.
[[nodiscard]] PointPlaneCase decidePointPlane(const Vec3<double> &point, const Plane<double> &plane);

/// The case of `intersectRayPlane`.
[[nodiscard]] RayPlaneCase decideRayPlane(const Ray<double> &ray, const Plane<double> &plane);

/// The shape of `shapeOf`.
[[nodiscard]] TriangleShape decideShape(const Triangle<double> &triangle);

struct RayTriangleVerdict {
  RayTriangleCase which = RayTriangleCase::Coincident;
  FaceLocation location; ///< Outside, too, where the line does not cross the plane in one point
};

/// The case and the place of `intersectRayTriangle`.
[[nodiscard]] RayTriangleVerdict decideRayTriangle(const Ray<double> &ray, const Triangle<double> &triangle);

/// The t of a Hit of `intersectRayTriangle`, in exact arithmetic from the start; nothing in any other case.
/// (1) It is plane.t of the query on exactly(ray) and exactly(triangle).
[[nodiscard]] std::optional<Rational> exactHit(const Ray<double> &ray, const Triangle<double> &triangle);
[[nodiscard]] std::optional<Rational> exactHit(const Ray<Rational> &ray, const Triangle<double> &triangle);

/// The t of `intersectRayTriangle`. Requires a ray whose line crosses the triangle's plane in one point.
/// (1) It is plane.t of the query on exactly(ray) and exactly(triangle).
[[nodiscard]] Rational exactT(const Ray<double> &ray, const Triangle<double> &triangle);

struct RaySphereVerdict {
  RaySphereCase which = RaySphereCase::ZeroDirection;
  SphereContacts contacts = SphereContacts::None;
};

/// The case and the contacts of `intersectRaySphere`. Requires a radius > 0.
[[nodiscard]] RaySphereVerdict decideRaySphere(const Ray<double> &ray, const Sphere<double> &sphere);

/// The fractions that doubles are. Require finite ones.
[[nodiscard]] Vec3<Rational> exactly(const Vec3<double> &vector);
[[nodiscard]] Ray<Rational> exactly(const Ray<double> &ray);
[[nodiscard]] Plane<Rational> exactly(const Plane<double> &plane);
[[nodiscard]] Triangle<Rational> exactly(const Triangle<double> &triangle);
[[nodiscard]] Sphere<Rational> exactly(const Sphere<double> &sphere);

} // namespace halfspace
