// The coordinates of points and vectors, one by one.
#pragma once

#include "lessons/term/term.h"

#include <array>
#include <string>

namespace halfspace {

inline constexpr std::array axisNames{"x", "y", "z"};

/// A coordinate of a point or a vector, by a name of its own: Q_x of Q. It is the same mark, and the same
/// coordinate of the scene.
[[nodiscard]] Term componentOf(const Term &whole, Symbol symbol, int axis);

/// Q_x for Q, and r_x for the vector r.
[[nodiscard]] Symbol indexed(Symbol symbol, const std::string &index);

/// The number that a term comes to.
[[nodiscard]] Rational rationalOf(const Term &number);

} // namespace halfspace
