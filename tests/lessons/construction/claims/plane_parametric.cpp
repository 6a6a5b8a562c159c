#include "lessons/object/kinds/point.h"
#include "tests/lessons/construction/claims/triangle_words.h"

namespace halfspace::test {
namespace {

struct PointBySides : TriangleCorners {
  explicit PointBySides(Objects objects)
      : TriangleCorners(objects), P(objectAs<PointObject>(*objects[1])->at) {}

  bool isInPlane() const { return isTriangle() && product(n, ExactVec3(P - corners[0])) == 0; }

  /// 1 − s − t, s and t: the volumes over the opposite sides, along n. Requires a triangle.
  std::array<Rational, 3> weights() const {
    std::array<Rational, 3> weights;
    for (std::size_t i = 0; i < 3; ++i)
      weights.at(i) =
          determinant(n, ExactVec3(corners.at((i + 1) % 3) - P), ExactVec3(corners.at((i + 2) % 3) - P)) /
          product(n, n);
    return weights;
  }

  ExactVec3 P;
};

bool isTriangle(const PointBySides &at) { return at.isTriangle(); }
bool isInPlane(const PointBySides &at) { return at.isInPlane(); }
bool isBeside(const PointBySides &at) { return at.isInPlane() && isOutside(at.weights()); }
bool isOffPlane(const PointBySides &at) { return at.isTriangle() && !at.isInPlane(); }

} // namespace

namespace claims {

Claims plane_parametric() {
  const Claims own = claimsAbout<PointBySides>({
      {"{P} is outside the triangle: {s}, {t}.", isBeside},
      {"{P} does not lie in the triangle's plane: no s and t lead to it.", isOffPlane},
      {"{first} and {second} are the same point: the corners span no plane.", areSamePoint},
      {"{P0}, {P1} and {P2} lie on one line: every s and t lead to a point of this line, and the corners "
       "span no plane.",
       [](const PointBySides &at) { return at.isCollinear(); }},
      {"Two sides of the triangle, both from {P0}.", always},
      {"From {P0}, s steps of u and then t steps of v.", isInPlane},
      {"The same point without u and v: a mixture of the three corners.", isInPlane},
      {"At least one is negative: {P} is outside the triangle.", isBeside},
      {"Perpendicular to u and to v, so it is a normal of the plane.", isTriangle},
      {"The zero vector: u and v lie along one line and span no plane.",
       [](const PointBySides &at) { return !at.isTriangle(); }},
      {"The implicit equation, with u × v for the normal.", isTriangle},
      {"{P} satisfies it, whatever s and t are.", isInPlane},
      {"Not 0: {P} does not lie in the plane.", isOffPlane},
  });
  return together(
      {own,
       placeClaims(isInPlane, "{P} is inside the triangle: {s}, {t}.", "{P} is on the edge {edge}: {s}, {t}.",
                   "{P} is at the corner {corner}: {s}, {t}."),
       placeClaims(isInPlane, "All three are positive: {P} is inside the triangle.",
                   "One is 0 and the others are positive: {P} is on the edge {edge}.",
                   "Two are 0: {P} is at the corner {corner}.")});
}

} // namespace claims
} // namespace halfspace::test
