#include "lessons/object/kinds/point.h"
#include "tests/lessons/construction/claims/triangle_words.h"

namespace halfspace::test {
namespace {

struct PointAtTriangle : TriangleCorners {
  explicit PointAtTriangle(Objects objects)
      : TriangleCorners(objects), Q(objectAs<PointObject>(*objects[1])->at) {}

  bool isInPlane() const { return isTriangle() && product(n, ExactVec3(Q - corners[0])) == 0; }

  /// By the normals of the small triangles, measured along n.
  std::array<Rational, 3> weights() const {
    std::array<Rational, 3> weights;
    for (std::size_t i = 0; i < 3; ++i)
      weights.at(i) = product(n, perpendicular(ExactVec3(corners.at((i + 1) % 3) - Q),
                                               ExactVec3(corners.at((i + 2) % 3) - Q))) /
                      product(n, n);
    return weights;
  }

  /// How many weights are negative; none where there are no weights.
  long negative() const {
    if (!isInPlane())
      return 0;
    const auto all = weights();
    return std::count_if(all.begin(), all.end(), [](const Rational &each) { return each < 0; });
  }

  ExactVec3 Q;
};

bool isInPlane(const PointAtTriangle &at) { return at.isInPlane(); }

/// The corner opposite to the small triangle that a line is about: n0, area0, n1, area1, n2.
std::size_t cornerOf(const Said &said) { return static_cast<std::size_t>(said.line.back() - '0'); }

Rational weightOf(const PointAtTriangle &at, const Said &said) { return at.weights().at(cornerOf(said)); }

} // namespace

namespace claims {

Claims barycentric() {
  const Claims own = claimsAbout<PointAtTriangle>({
      {"One weight is negative: {Q} is outside the triangle. {rho}, {sigma}, {tau}.",
       [](const PointAtTriangle &at) { return at.negative() == 1; }},
      {"Two weights are negative: {Q} is outside the triangle. {rho}, {sigma}, {tau}.",
       [](const PointAtTriangle &at) { return at.negative() == 2; }},
      {"{Q} does not lie in the triangle's plane, so no weights of the three corners lead to it.",
       [](const PointAtTriangle &at) { return at.isTriangle() && !at.isInPlane(); }},
      {"{P0}, {P1} and {P2} lie on one line: the triangle has no area to share.",
       [](const PointAtTriangle &at) { return at.isCollinear(); }},
      {"It is as long as twice the triangle's area.", always},
      {"A triangle is half of a parallelogram.", always},
      {"The same for the small triangle of {Q} and the edge {edge}.",
       [](const PointAtTriangle &, const Said &said) {
         return isEdgeOppositeTo(cornerOf(said), said.at("edge"));
       }},
      {"The three together are n, wherever {Q} is.", isInPlane},
      {"{normal} points against n: {Q} is beyond this edge, and the area counts as negative.",
       [](const PointAtTriangle &at, const Said &said) { return at.isInPlane() && weightOf(at, said) < 0; }},
      {"No area is left: {Q} is on the line of this edge.",
       [](const PointAtTriangle &at, const Said &said) { return at.isInPlane() && weightOf(at, said) == 0; }},
      {"{normal} points the same way as n, so the area counts as positive.",
       [](const PointAtTriangle &at, const Said &said) { return at.isInPlane() && weightOf(at, said) > 0; }},
      {"The three small areas together are the whole: so the third is what is left.", isInPlane},
      {"The weight of {corner}: the share of the small triangle opposite to it.",
       [](const PointAtTriangle &at, const Said &said) {
         return at.isInPlane() && cornerNamed(said.at("corner")) == (said.line == "rho" ? 0 : 1);
       }},
      {"The three weights add up to 1, so the last one is what is left.", isInPlane},
      {"The corners mixed with these weights give the point {Q} again.", isInPlane},
      {"Here the line through {Q}, parallel to the edge {edge}, meets the line {other}.",
       [](const PointAtTriangle &at, const Said &said) {
         return at.isInPlane() && isEdgeOppositeTo(0, said.at("edge")) &&
                isEdgeOppositeTo(2, said.at("other"));
       }},
      {"{Q} is outside the triangle.",
       [](const PointAtTriangle &at) { return at.isInPlane() && isOutside(at.weights()); }},
  });
  return together(
      {own,
       placeClaims(
           isInPlane, "All three weights are positive: {Q} is inside the triangle. {rho}, {sigma}, {tau}.",
           "One weight is 0 and the others are positive: {Q} is on the edge {edge}. {rho}, {sigma}, {tau}.",
           "One weight is 1 and the others are 0: {Q} is at the corner {corner}. {rho}, {sigma}, {tau}."),
       placeClaims(isInPlane, "{Q} is inside the triangle.", "{Q} is on the edge {edge}.",
                   "{Q} is at the corner {corner}."),
       coincidenceClaims(
           "{first} and {second} are the same point: this is no triangle, and there is no area to share.",
           "{first}, {second} and {third} are the same point: this is no triangle, and there is no area to "
           "share.")});
}

} // namespace claims
} // namespace halfspace::test
