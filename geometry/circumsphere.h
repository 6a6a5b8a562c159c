// The sphere through four points.
#pragma once

#include "geometry/surd.h"
#include "geometry/vector.h"

#include <array>

namespace halfspace {

/// NoSphere and ManySpheres are of points in one plane: of several on a circle infinitely many spheres go
/// through all.
enum class CircumsphereCase { Sphere, NoSphere, ManySpheres };

/// What four points have for a sphere, with every number on the way.
template <class Scalar> struct Circumsphere {
  CircumsphereCase which = CircumsphereCase::NoSphere;
  std::array<Vec3<Scalar>, 3> sides{};   ///< u, v, w: from the first point to the others
  std::array<Vec3<Scalar>, 3> normals{}; ///< v×w, w×u, u×v
  Scalar determinant{};                  ///< u·(v×w)
  Vec3<Scalar> numerator{};              ///< u²(v×w) + v²(w×u) + w²(u×v)
  Vec3<Scalar> center{};
  Scalar radiusSquared{};
  Root<Scalar> radius{};
};

/// Whether more than one sphere goes through points whose sides lie in one plane. `numerator` as above.
/// (1) Exactly where some x fulfils 2u·x = u², 2v·x = v² and 2w·x = w².
template <class Scalar>
[[nodiscard]] bool haveSphereInPlane(const std::array<Vec3<Scalar>, 3> &sides,
                                     const Vec3<Scalar> &numerator) {
  if (!isZero(numerator))
    return false;
  const auto &[u, v, w] = sides;
  if (!isZero(cross(u, v)) || !isZero(cross(v, w)) || !isZero(cross(w, u)))
    return true;
  // All on one line: a line meets a sphere in two points at most.
  const auto areOne = [](const Vec3<Scalar> &a, const Vec3<Scalar> &b) {
    return isZero(a) || isZero(b) || a == b;
  };
  return areOne(u, v) && areOne(v, w) && areOne(w, u);
}

/// The sphere through four points, from the equations |M − A|² = |M − B|² and so on, which are linear in M.
/// Center and radius are set for Sphere alone.
/// (1) |center − corner| = radius for each of the points.
/// (2) The determinant is 0 exactly for NoSphere and ManySpheres.
/// (3) The same case, center and radius for the points in any order; moved points move the center.
/// (4) k times as large points, k ≠ 0: k times the center, |k| times the radius.
template <class Scalar>
[[nodiscard]] Circumsphere<Scalar> circumsphereOf(const std::array<Vec3<Scalar>, 4> &points) {
  Circumsphere<Scalar> result;
  for (std::size_t i = 0; i < 3; ++i)
    result.sides[i] = points[i + 1] - points[0];
  const auto &[u, v, w] = result.sides;
  result.normals = {cross(v, w), cross(w, u), cross(u, v)};
  result.determinant = dot(u, result.normals[0]);
  for (std::size_t i = 0; i < 3; ++i)
    result.numerator += result.normals[i] * dot(result.sides[i], result.sides[i]);
  if (result.determinant == Scalar(0)) {
    result.which = haveSphereInPlane(result.sides, result.numerator) ? CircumsphereCase::ManySpheres
                                                                     : CircumsphereCase::NoSphere;
    return result;
  }
  result.which = CircumsphereCase::Sphere;
  const Vec3<Scalar> way = result.numerator * Scalar(Scalar(1) / Scalar(Scalar(2) * result.determinant));
  result.center = points[0] + way;
  result.radiusSquared = dot(way, way);
  result.radius = timesRoot(Scalar(1), result.radiusSquared);
  return result;
}

} // namespace halfspace
