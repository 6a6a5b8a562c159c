#include "lessons/term/angle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace halfspace {
namespace {

struct WholeAngle {
  int degrees;
  Surd cosine;
};

/// Those of at most 90°.
const std::array<WholeAngle, 7> &wholeAngles() {
  static const std::array<WholeAngle, 7> angles{{{0, 1},
                                                 {30, Surd::root(3, Rational(1, 2))},
                                                 {36, Surd::root(5, Rational(1, 4)) + Rational(1, 4)},
                                                 {45, Surd::root(2, Rational(1, 2))},
                                                 {60, Rational(1, 2)},
                                                 {72, Surd::root(5, Rational(1, 4)) + Rational(-1, 4)},
                                                 {90, 0}}};
  return angles;
}

} // namespace

WrittenNumber degreesOf(const Term &cosine) {
  const Real &number = *numberOf(cosine);
  if (const Surd *exact = number.exact())
    for (const auto &[degrees, itsCosine] : wholeAngles()) {
      if (*exact == itsCosine)
        return {Term(degrees), true};
      if (*exact == -itsCosine)
        return {Term(180 - degrees), true};
    }
  const double degrees = std::acos(std::clamp(toDouble(number), -1.0, 1.0)) * 180 / std::numbers::pi;
  return {rounded(degrees, digitsAmongWords), false};
}

} // namespace halfspace
