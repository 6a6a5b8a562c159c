// Numbers that are compared with each other while they change.
#pragma once

#include "lessons/term/written.h"

namespace halfspace {

/// As a decimal of at most so many places behind the point, exact only where it has no more. From a thousand
/// on with as many digits as other numbers have. Requires 0 ≤ places ≤ 6.
[[nodiscard]] WrittenNumber shortDecimal(const Rational &number, int places);

} // namespace halfspace
