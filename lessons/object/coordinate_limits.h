// Which objects have coordinates beyond the limits.
#pragma once

#include "lessons/object/object.h"
#include "lessons/reading/typed_number.h"

namespace halfspace {

/// What a construction makes may have longer numbers, but not without end: each one made of another has
/// several times as many digits.
inline constexpr std::size_t madeDigits = 400;
/// Whether an object that was made has longer ones.
[[nodiscard]] bool hasEndlessNumbers(const Object &made);

/// Why a coordinate of the object may not be what it is, with the coordinate's name; nothing where all may.
struct RefusedCoordinate {
  std::string_view name;
  std::string sentence;
};
[[nodiscard]] std::optional<RefusedCoordinate> refusedCoordinateOf(const Object &object);

} // namespace halfspace
