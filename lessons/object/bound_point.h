// What the kinds of points have in common that lie on another object and keep to it.
#pragma once

#include "lessons/object/kind.h"

namespace halfspace {

/// A kind of points that lie on another object. They are drawn, offered and looked at as the points that they
/// are.
[[nodiscard]] Kind boundPoint(std::string_view word, std::string (*noun)(), std::string_view meaning,
                              std::vector<CoordinateSpec> freedoms, void (*settle)(Object &),
                              const Binding &binding);

/// Of points by their λ on what has a point first and a direction second: a line, a ray.
[[nodiscard]] Binding bindingByLambda(std::string_view host);

/// The handle of a bound object that lies at a place of its host.
[[nodiscard]] Handle boundHandle(const std::string &name, const Object &bound, const Object &host,
                                 const ExactVec3 &at);

/// No freedom goes in finer steps.
inline const Rational finestFreedom(1, 1000000000);
/// The largest of 1, 1/2, 1/4, 1/10, 1/20, 1/40 … by which a freedom may go forward so that the point moves
/// at most two steps of the grid, where it moves by this length while the freedom grows by 1; but
/// finestFreedom at least.
[[nodiscard]] Rational freedomStep(const Rational &gridStep, const Rational &squaredLength);

} // namespace halfspace
