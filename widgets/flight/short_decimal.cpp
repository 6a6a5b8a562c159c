#include "widgets/flight/short_decimal.h"

namespace halfspace {

WrittenNumber shortDecimal(const Rational &number, int places) {
  constexpr int large = 1000;
  if (abs(number) >= large)
    return decimalOf(Surd(number));
  const Rational near = roundToMultiple(number, powerOfTen(-places));
  return {decimalOf(Surd(near)).term, near == number};
}

} // namespace halfspace
