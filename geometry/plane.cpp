#include "geometry/plane.h"

#include "geometry/primitive_integers.h"

namespace halfspace {

std::array<Integer, 4> primitiveCoefficients(const Plane<Rational> &plane) {
  return primitiveIntegers<4>({plane.normal.x, plane.normal.y, plane.normal.z, plane.offset});
}

} // namespace halfspace
