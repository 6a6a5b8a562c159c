#include "widgets/flight/short_decimal.h"

#include "geometry/decide.h"
#include "lessons/term/plain_text.h"

#include <cmath>

namespace halfspace {

WrittenNumber shortDecimal(const Rational &number, int places) {
  constexpr int large = 1000;
  if (abs(number) >= large)
    return decimalOf(Surd(number));
  const Rational near = roundToMultiple(number, powerOfTen(-places));
  return {decimalOf(Surd(near)).term, near == number};
}

std::optional<WrittenNumber> shortParameter(double t) {
  constexpr int places = 3;
  return std::isfinite(t) ? std::optional(shortDecimal(exactly(t), places)) : std::nullopt;
}

QString readoutOf(const std::optional<WrittenNumber> &parameter) {
  return "λ" + (parameter ? QString::fromStdString(relatedText(*parameter)) : QStringLiteral(" = ?"));
}

} // namespace halfspace
