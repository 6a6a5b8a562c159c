// The plane through three points, as formulas.
#pragma once

#include "lessons/formula/formula.h"

#include <array>
#include <optional>

namespace halfspace {

/// B − A: leads from one place to the other.
[[nodiscard]] Formula wayBetween(const Formula &from, const Formula &to);

/// The point of the plane and its normal: A and shortest((B − A) × (C − A)), so that its equation has whole
/// numbers without a common factor.
[[nodiscard]] std::vector<Formula> planeThrough(const Formula &a, const Formula &b, const Formula &c);

/// The three points of coordinates that `planeThrough` made; nothing for others.
[[nodiscard]] std::optional<std::array<Formula, 3>> pointsOfPlane(const std::vector<Formula> &coordinates);

} // namespace halfspace
