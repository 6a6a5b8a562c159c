// Objects by the numbers that they have.
#pragma once

#include "lessons/object/object.h"

namespace halfspace::test {

/// With these coordinates, and as many vertices as they take.
inline Object objectOf(std::string_view kind, const std::vector<ExactVec3> &coordinates) {
  Object object = makeObject(kind).value();
  while (object.size() < coordinates.size())
    object.addVertex();
  for (std::size_t i = 0; i < coordinates.size(); ++i)
    object[i] = coordinates[i];
  return object;
}

/// Of a kind whose coordinates are single numbers.
inline Object withNumbers(std::string_view kind, const std::vector<Rational> &numbers) {
  Object object = makeObject(kind).value();
  for (std::size_t i = 0; i < numbers.size(); ++i)
    object[i].x = numbers[i];
  return object;
}

inline Object polygonOf(const std::vector<ExactVec3> &corners) { return objectOf("polygon", corners); }

} // namespace halfspace::test
