#include "lessons/object/coordinate_limits.h"

namespace halfspace {

bool hasEndlessNumbers(const Object &made) {
  static const Rational limit = powerOfTen(madeDigits);
  for (std::size_t index = 0; index < made.size(); ++index)
    for (int axis = 0; axis < 3; ++axis)
      if (const Rational &number = made[index][axis];
          abs(number.numerator()) > limit || number.denominator() > limit)
        return true;
  return false;
}

std::optional<RefusedCoordinate> refusedCoordinateOf(const Object &object) {
  const auto &specs = coordinatesOf(object);
  for (std::size_t index = 0; index < specs.size(); ++index)
    for (int axis = 0; axis < numbersIn(specs[index].role); ++axis)
      if (auto sentence = refuseCoordinate(coordinate(object, index)[axis]))
        return RefusedCoordinate{specs[index].name, std::move(*sentence)};
  return {};
}

} // namespace halfspace
