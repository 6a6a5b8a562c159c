#include "geometry/exact_root.h"

#include "geometry/integer.h"

namespace halfspace {
namespace {

std::optional<Integer> exactRootOf(const Integer &square) {
  Integer root = mp::sqrt(square);
  return root * root == square ? std::optional(std::move(root)) : std::nullopt;
}

} // namespace

std::optional<Rational> exactRoot(const Rational &square) {
  if (square.sign() < 0)
    return {};
  // In lowest terms a fraction is a square only where both its parts are.
  const auto numerator = exactRootOf(numeratorOf(square));
  const auto denominator = numerator ? exactRootOf(denominatorOf(square)) : std::nullopt;
  return denominator ? std::optional(rationalOf(*numerator) / rationalOf(*denominator)) : std::nullopt;
}

} // namespace halfspace
