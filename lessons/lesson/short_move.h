// The way to a special case that keeps the numbers short.
#pragma once

#include "lessons/scene/near_special_cases.h"

namespace halfspace {

/// A move that leads to a special case and keeps short numbers, not much longer than the least one: to a
/// place of the grid if there is one, else along an axis, else the least itself. Requires `near.change`.
[[nodiscard]] ChangeObject shortMoveTo(const NearSpecialCase &near, const Scene &scene, const Rational &step);

} // namespace halfspace
