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

  /// How many weights are on this side of 0; none where there are no weights.
  long countWeights(int sign) const {
    if (!isInPlane())
      return 0;
    const auto all = weights();
    return std::count_if(all.begin(), all.end(),
                         [sign](const Rational &each) { return each.sign() == sign; });
  }

  ExactVec3 P;
};

bool isTriangle(const PointBySides &at) { return at.isTriangle(); }
bool isInPlane(const PointBySides &at) { return at.isInPlane(); }
bool isOffPlane(const PointBySides &at) { return at.isTriangle() && !at.isInPlane(); }

} // namespace

namespace claims {

Claims plane_parametric() {
  const Claims own = claimsAbout<PointBySides>({
      {"{P} is {place}: {s}, {t}.", isInPlane},
      {"{P} does not lie in the triangle's plane: no s and t lead to it.", isOffPlane},
      {"{first} and {second} are the same point: the corners span no plane.", areSamePoint},
      {"{P0}, {P1} and {P2} lie on one line: every s and t lead to a point of this line, and the corners "
       "span no plane.",
       [](const PointBySides &at) { return at.isCollinear(); }},
      {"Two sides of the triangle, both from {P0}.", always},
      {"From {P0}, s steps of u and then t steps of v.", isInPlane},
      {"The same point without u and v: a mixture of the three corners.", isInPlane},
      {"All three are positive: {P} is {place}.",
       [](const PointBySides &at) { return at.countWeights(1) == 3; }},
      {"One is 0 and the others are positive: {P} is {place}.",
       [](const PointBySides &at) { return at.countWeights(0) == 1 && at.countWeights(1) == 2; }},
      {"Two are 0: {P} is {place}.", [](const PointBySides &at) { return at.countWeights(0) == 2; }},
      {"At least one is negative: {P} is {place}.",
       [](const PointBySides &at) { return at.countWeights(-1) >= 1; }},
      {"Perpendicular to u and to v, so it is a normal of the plane.", isTriangle},
      {"The zero vector: u and v lie along one line and have no normal.",
       [](const PointBySides &at) { return !at.isTriangle(); }},
      {"The implicit equation, with u × v for the normal.", isTriangle},
      {"{P} fulfils it, whatever s and t are.", isInPlane},
      {"Not 0: {P} does not lie in the plane.", isOffPlane},
  });
  return together({own, placeClaims<PointBySides>()});
}

} // namespace claims
} // namespace halfspace::test
