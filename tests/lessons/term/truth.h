// Numbers so precise that bounds can be held against them.
#pragma once

#include "geometry/surd.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace halfspace::test {

namespace mp = boost::multiprecision;

/// Digits beyond those of a term's own bounds, so that the truth is known better than the bounds say.
using Truth = mp::number<mp::cpp_bin_float<200>, mp::et_off>;

[[nodiscard]] inline Truth truthOf(const Rational &number) {
  return Truth(toText(number.numerator())) / Truth(toText(number.denominator()));
}
[[nodiscard]] inline Truth truthOf(const Surd &number) {
  return truthOf(number.rationalPart()) + truthOf(number.rootFactor()) * mp::sqrt(truthOf(number.radicand()));
}

} // namespace halfspace::test
