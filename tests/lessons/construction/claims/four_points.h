// Four points and the spheres through them, as the sentences of both constructions claim.
#pragma once

#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

#include <array>

namespace halfspace::test {

/// The points are lifted to x² + y² + z²: spheres are the planes of four dimensions. No system is solved.
struct FourPointsLifted {
  explicit FourPointsLifted(Objects objects) {
    for (const Object *object : objects) // one each, or all in one
      for (std::size_t i = 0; i < object->size(); ++i)
        points.at(count++) = (*object)[i];
    u = points[1] - points[0];
    v = points[2] - points[0];
    w = points[3] - points[0];
  }

  bool areFlat() const { return determinant(u, v, w) == 0; }
  bool areOne(std::size_t i, std::size_t k) const { return points.at(i) == points.at(k); }
  bool areTwoOne() const {
    return areOne(0, 1) || areOne(0, 2) || areOne(0, 3) || areOne(1, 2) || areOne(1, 3) || areOne(2, 3);
  }
  /// Without the point with this index, three different ones on a line.
  bool isLineWithout(std::size_t left) const {
    std::array<ExactVec3, 3> three;
    std::size_t next = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (i != left)
        three.at(next++) = points.at(i);
    const ExactVec3 first = three[1] - three[0];
    const ExactVec3 second = three[2] - three[1];
    return vanishes(perpendicular(first, second)) && !vanishes(first) && !vanishes(second) &&
           three[0] != three[2];
  }
  bool areThreeOnALine() const {
    return isLineWithout(0) || isLineWithout(1) || isLineWithout(2) || isLineWithout(3);
  }
  /// The squares of u, v, w depend on their coordinates as these do on each other: each determinant with the
  /// squares in the place of a coordinate is 0.
  bool isOnCircle() const {
    const ExactVec3 squares{product(u, u), product(v, v), product(w, w)};
    const auto row = [&](int axis) { return ExactVec3(u[axis], v[axis], w[axis]); };
    return areFlat() && determinant(squares, row(1), row(2)) == 0 &&
           determinant(row(0), squares, row(2)) == 0 && determinant(row(0), row(1), squares) == 0;
  }

  std::array<ExactVec3, 4> points{};
  std::size_t count = 0;
  ExactVec3 u, v, w;
};

inline bool hasSphere(const FourPointsLifted &at) { return !at.areFlat(); }
inline bool areFlat(const FourPointsLifted &at) { return at.areFlat(); }

[[nodiscard]] inline Claims sphereThroughClaims() {
  return claimsAbout<FourPointsLifted>({
      {"One sphere goes through all four points, with the centre {center} and the radius {radius}.",
       hasSphere},
      {"{first}, {second} and {third} lie on one line, and a sphere meets a line in two points at most: no "
       "sphere goes through all of them.",
       [](const FourPointsLifted &at) { return at.areThreeOnALine(); }},
      {"The four points lie in one plane, but not on one circle: no sphere goes through all of them.",
       [](const FourPointsLifted &at) {
         return at.areFlat() && !at.areTwoOne() && !at.areThreeOnALine() && !at.isOnCircle();
       }},
      {"{first} and {second} are the same point: through what is left go infinitely many spheres.",
       [](const FourPointsLifted &at) { return at.areTwoOne() && !at.areThreeOnALine(); }},
      {"The four points lie on one circle: infinitely many spheres go through it.",
       [](const FourPointsLifted &at) {
         return at.isOnCircle() && !at.areTwoOne() && !at.areThreeOnALine();
       }},
      {"From {from} to {to}.", always},
      {"This holds for the points (x, y, z) that are as far from {from} as from {to}: in the squares of both "
       "distances x², y² and z² are the same.",
       hasSphere},
      {"The determinant of the three equations. It is not 0: one point fulfils all of them.", hasSphere},
      {"The determinant of the equations for the centre is 0: the four points lie in one plane.", areFlat},
      {"The solution of the three equations, by Cramer's rule: the centre.", hasSphere},
      {"The radius: how far the centre is from any of the four.", hasSphere},
      {"The others are as far from the centre.", hasSphere},
  });
}

} // namespace halfspace::test
