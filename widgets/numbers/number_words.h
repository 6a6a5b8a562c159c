// What is said of a number in a formula that can be touched.
#pragma once

#include "lessons/term/term.h"

#include <QString>

namespace halfspace {

/// What a click on it does, in one short sentence.
[[nodiscard]] QString tipOf(const Term &number);

/// The number in words, with what it came from: minus 30, from P 0 minus Q, dot n.
[[nodiscard]] QString spokenWithOrigin(const Term &number);

/// A coordinate's number by its name: x of n.
[[nodiscard]] QString nameOfCoordinate(const Term &number);

} // namespace halfspace
