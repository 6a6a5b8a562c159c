// Which numbers may be coordinates.
#pragma once

#include "lessons/object/object.h"

namespace halfspace {

/// Coordinates are bounded so that every picture and every exact number stays within reason.
inline const Rational coordinateLimit = 1000000000;
/// The most digits of a coordinate's numerator or denominator.
inline constexpr std::size_t coordinateDigits = 40;

/// What a construction makes may have longer numbers, but not without end: each one made of another has
/// several times as many digits.
inline constexpr std::size_t madeDigits = 400;
/// Whether an object that was made has longer ones.
[[nodiscard]] bool hasEndlessNumbers(const Object &made);

/// The sentences for a number that is beyond the two bounds.
[[nodiscard]] std::string sentenceForTooLarge();
[[nodiscard]] std::string sentenceForTooLong();

/// Whether a typed number may become a coordinate; if not, the sentence that says why.
[[nodiscard]] std::optional<std::string> refuseCoordinate(const Rational &value);

/// Why a coordinate of the object may not be what it is, with the coordinate's name; nothing where all may.
struct RefusedCoordinate {
  std::string_view name;
  std::string sentence;
};
[[nodiscard]] std::optional<RefusedCoordinate> refusedCoordinateOf(const Object &object);

} // namespace halfspace
