// Square roots that are fractions.
#pragma once

#include "geometry/rational.h"

#include <optional>

namespace halfspace {

/// The root of a square of fractions; nothing for any other number.
/// (1) exactRoot(x²) = |x|.
[[nodiscard]] std::optional<Rational> exactRoot(const Rational &square);

} // namespace halfspace
