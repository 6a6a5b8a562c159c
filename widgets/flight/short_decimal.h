// Numbers that are compared with each other while they change.
#pragma once

#include "lessons/term/written.h"

#include <QString>

#include <optional>

namespace halfspace {

/// As a decimal of at most so many places behind the point, exact only where it has no more. From a thousand
/// on with as many digits as other numbers have. Requires 0 ≤ places ≤ 6.
[[nodiscard]] WrittenNumber shortDecimal(const Rational &number, int places);

/// A ray's parameter while it changes, to three places; nothing where it is not finite.
[[nodiscard]] std::optional<WrittenNumber> shortParameter(double t);
/// The same as it is read: λ ≈ 0.33, or λ = ? for nothing.
[[nodiscard]] QString readoutOf(const std::optional<WrittenNumber> &parameter);

} // namespace halfspace
