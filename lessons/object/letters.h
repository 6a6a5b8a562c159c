// Letters as terms that know the coordinates they are.
#pragma once

#include "lessons/object/given.h"
#include "lessons/term/chain.h"

#include <string>

namespace halfspace {

namespace detail {
[[nodiscard]] Term coordinateTerm(const std::string &id, bool isFree, const Symbol &letter,
                                  const Object &object, std::size_t index);
} // namespace detail

/// The letter of an object's coordinate. Of a free object it knows the coordinate that it is; what a
/// construction made is told by that one's lines.
template <class Kind> [[nodiscard]] Term coordinateTerm(const Given<Kind> &given, std::size_t index) {
  return detail::coordinateTerm(given.id, given.isFree, given.letters.at(index), given.object, index);
}

/// P₀P₁ in plain text; P₀_T to P₁_T where the letters say whose they are.
[[nodiscard]] std::string edgeName(const Symbol &from, const Symbol &to);

/// P = (x, y, z): any point of space.
[[nodiscard]] Term anyPoint();

/// The point or vector that a term comes to whose coordinates are fractions.
[[nodiscard]] ExactVec3 vectorOf(const Term &term);

/// Whether the vector is one unit long.
[[nodiscard]] bool isUnit(const Term &vector);

/// The name with its value, in plain text: `t = −10/3`, or `t ≈ 0.2718` when it is rounded.
[[nodiscard]] std::string equation(const Term &name);

} // namespace halfspace
