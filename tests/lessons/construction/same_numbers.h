// Whether a construction's numbers are those that other formulas come to.
#pragma once

#include "tests/lessons/construction/expected/expected.h"

#include "geometry/surd.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

namespace halfspace::test {

/// Numbers that are fractions, or roots alone.
inline SignedSquares signedSquaresOf(const std::vector<Surd> &numbers) {
  SignedSquares squares;
  for (const Surd &number : numbers) {
    EXPECT_TRUE(number.isRational() || number.rationalPart() == 0);
    EXPECT_TRUE(std::isfinite(toDouble(number)));
    squares.push_back(Rational(signedSquare(number.rationalPart()) +
                               signedSquare(number.rootFactor()) * number.radicand()));
  }
  return squares;
}

inline bool isSame(const Surd &number, const SumWithRoot &expected) {
  return signedSquaresOf({number + Rational(-expected.number)}).front() == expected.signedSquare;
}

inline bool areSame(const std::vector<Surd> &numbers,
                    const std::variant<SignedSquares, SumsWithRoots, std::string, int> &expected) {
  const auto *sums = std::get_if<SumsWithRoots>(&expected);
  return sums ? std::equal(numbers.begin(), numbers.end(), sums->begin(), sums->end(), isSame)
              : std::get<SignedSquares>(expected) == signedSquaresOf(numbers);
}

} // namespace halfspace::test
