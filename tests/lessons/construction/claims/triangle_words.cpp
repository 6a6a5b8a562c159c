#include "tests/lessons/construction/claims/triangle_words.h"

#include "lessons/object/kinds/ray.h"
#include "tests/lessons/construction/claims/corner_letters.h"

namespace halfspace::test {

std::size_t cornerNamed(const std::string &letter) { return cornerWithLetter(letter, 3); }

bool isEdgeOppositeTo(std::size_t corner, const std::string &name) {
  const std::string from = cornerLetter((corner + 1) % 3);
  const std::string to = cornerLetter((corner + 2) % 3);
  return name == from + to || name == to + from;
}

bool isOnEdge(const std::array<Rational, 3> &weights, const std::string &name) {
  const auto zero = std::find(weights.begin(), weights.end(), Rational(0));
  return std::count_if(weights.begin(), weights.end(), [](const Rational &each) { return each > 0; }) == 2 &&
         zero != weights.end() && isEdgeOppositeTo(static_cast<std::size_t>(zero - weights.begin()), name);
}

bool isAtCorner(const std::array<Rational, 3> &weights, const std::string &name) {
  const std::size_t corner = cornerNamed(name);
  return weights.at(corner) == 1 && std::count(weights.begin(), weights.end(), Rational(0)) == 2;
}

bool areSamePoint(const TriangleCorners &at, const Said &said) {
  return at.corners.at(cornerNamed(said.at("first"))) == at.corners.at(cornerNamed(said.at("second")));
}

Claims coincidenceClaims(const char *two, const char *three,
                         const std::function<bool(const TriangleCorners &, const Said &)> &besides) {
  return claimsAbout<TriangleCorners>({
      {two, [besides](const TriangleCorners &at,
                      const Said &said) { return areSamePoint(at, said) && besides(at, said); }},
      {three,
       [besides](const TriangleCorners &at, const Said &said) {
         return at.corners[0] == at.corners[1] && at.corners[0] == at.corners[2] && besides(at, said);
       }},
  });
}

Claims crossProductClaims() {
  return claimsAbout<TriangleCorners>({
      {"Perpendicular to both sides.", [](const TriangleCorners &at) { return at.isTriangle(); }},
      {"The zero vector: u and v lie along one line and span no plane.",
       [](const TriangleCorners &at) { return !at.isTriangle(); }},
  });
}

Claims zeroPerpClaims() {
  return claimsAbout<TriangleCorners>({
      {"The zero vector: u and v lie along one line, so it points nowhere.",
       [](const TriangleCorners &at) { return !at.isTriangle(); }},
  });
}

Claims zeroDirectionClaims(std::size_t ray) {
  return {
      {"The direction {r} is the zero vector: the ray goes nowhere.", [ray](Objects objects, const Said &) {
         return vanishes(objectAs<RayObject>(*objects[ray])->direction);
       }}};
}

} // namespace halfspace::test
