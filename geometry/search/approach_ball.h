// Where a ray that begins very far away comes near what it may hit.
#pragma once

#include "geometry/ray.h"

#include <optional>

namespace halfspace {

/// Where along a ray it comes near the ball around `middle`: a t ≥ 0 before which it is outside of the ball.
/// Nothing where it surely never meets the ball. Requires a direction ≠ 0, and a radius > 0.
/// (1) The point of the ray at t is at most 2^20 radii from the middle, and t is 0 where its origin is so
///     near; unless the ray's numbers are beyond the range of doubles: then t is 0 as well.
[[nodiscard]] std::optional<Rational> approachBall(const Ray<Rational> &ray, const Vec3<double> &middle,
                                                   double radius);

} // namespace halfspace
