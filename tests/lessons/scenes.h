// Scenes that several tests begin with, and exact values that print themselves.
#pragma once

#include "lessons/scene/handles.h"
#include "lessons/scene/session.h"

#include <ostream>

// GoogleTest finds it by the type's own namespace.
namespace glm {
inline void PrintTo(const halfspace::ExactVec3 &v, std::ostream *stream) {
  *stream << "(" << halfspace::toText(v.x) << ", " << halfspace::toText(v.y) << ", " << halfspace::toText(v.z)
          << ")";
}
} // namespace glm

namespace halfspace::test {

inline Rational q(int numerator, int denominator = 1) { return Rational(numerator, denominator); }

inline Entry planeE() { return {"E", PlaneObject{{5, 4, 7}, {1, 2, 2}}}; }
inline Entry pointQ() { return {"Q", PointObject{{11, 15, 8}}}; }
inline Entry rayL() { return {"L", RayObject{{11, 15, 8}, {-1, 3, 2}}}; }
inline Entry triangleT() { return {"T", TriangleObject{{9, 9, 0}, {1, 9, 4}, {5, 2, 9}}}; }

/// A plane and a point with their distance.
inline Scene distanceScene() {
  return {{planeE(), pointQ(), {"distance", ConstructionUse{"signed-distance", {{"E", "E"}, {"Q", "Q"}}}}}};
}

/// The handle of a scene with this id; the test fails where there is none.
inline Handle handle(const Scene &scene, const std::string &id) {
  for (Handle &each : handlesOf(scene))
    if (each.id == id)
      return each;
  throw std::out_of_range("no handle " + id);
}

} // namespace halfspace::test
