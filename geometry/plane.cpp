#include "geometry/plane.h"

#include "geometry/primitive_integers.h"

#include <cassert>

namespace halfspace {

std::array<Integer, 4> primitiveCoefficients(const Plane<Rational> &plane) {
  assert(!isZero(plane.normal));
  return primitiveIntegers<4>({plane.normal.x, plane.normal.y, plane.normal.z, plane.offset});
}

} // namespace halfspace
