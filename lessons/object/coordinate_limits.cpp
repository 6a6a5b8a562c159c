#include "lessons/object/coordinate_limits.h"

#include "lessons/words.h"

namespace halfspace {
namespace {

bool hasTooManyDigits(const Rational &whole) {
  static const Rational shortestTooLong = powerOfTen(coordinateDigits);
  return abs(whole) >= shortestTooLong;
}

} // namespace

bool hasEndlessNumbers(const Object &made) {
  static const Rational limit = powerOfTen(madeDigits);
  for (std::size_t index = 0; index < made.size(); ++index)
    for (int axis = 0; axis < 3; ++axis)
      if (const Rational &number = made[index][axis];
          abs(number.numerator()) > limit || number.denominator() > limit)
        return true;
  return false;
}

std::string sentenceForTooLarge() {
  return words("This number is too large: coordinates go from −{limit} to {limit}.",
               {{"limit", toText(coordinateLimit)}});
}

std::string sentenceForTooLong() {
  return words("This number is too long: as a fraction it may have {digits} digits above and below the line.",
               {{"digits", std::to_string(coordinateDigits)}});
}

std::optional<std::string> refuseCoordinate(const Rational &value) {
  if (abs(value) > coordinateLimit)
    return sentenceForTooLarge();
  if (hasTooManyDigits(value.numerator()) || hasTooManyDigits(value.denominator()))
    return sentenceForTooLong();
  return {};
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
