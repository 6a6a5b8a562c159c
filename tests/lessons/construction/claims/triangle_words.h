// What several constructions say of a triangle and of a place in it.
#pragma once

#include "lessons/object/kinds/triangle.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

#include <algorithm>
#include <array>

namespace halfspace::test {

struct TriangleCorners {
  explicit TriangleCorners(const std::array<ExactVec3, 3> &places)
      : corners(places), u(corners[1] - corners[0]), v(corners[2] - corners[0]), n(perpendicular(u, v)) {}

  /// Those of the first object.
  explicit TriangleCorners(Objects objects)
      : TriangleCorners(std::array{(*objects[0])[0], (*objects[0])[1], (*objects[0])[2]}) {}

  bool isTriangle() const { return !vanishes(n); }
  bool isCoincident() const {
    return corners[0] == corners[1] || corners[0] == corners[2] || corners[1] == corners[2];
  }
  bool isCollinear() const { return !isTriangle() && !isCoincident(); }

  std::array<ExactVec3, 3> corners;
  ExactVec3 u, v, n;
};

/// Of the weights of a point in the plane.
[[nodiscard]] inline bool isOutside(const std::array<Rational, 3> &weights) {
  return *std::min_element(weights.begin(), weights.end()) < 0;
}

/// The corner with this letter; 3 where none has it.
[[nodiscard]] std::size_t cornerNamed(const std::string &letter);

/// Of the edge between the corners that follow on this one, as a sentence names it: in either direction.
[[nodiscard]] bool isEdgeOppositeTo(std::size_t corner, const std::string &name);

/// Whether a place is an edge of the triangle, or a corner, and is the one that the sentence names.
[[nodiscard]] bool isOnEdge(const std::array<Rational, 3> &weights, const std::string &name);
[[nodiscard]] bool isAtCorner(const std::array<Rational, 3> &weights, const std::string &name);

/// The places of a triangle that a hit can have: `Scene` has the weights of the point.
template <class Scene> [[nodiscard]] Claims hitPlaceClaims() {
  return claimsAbout<Scene>({
      {"inside the triangle",
       [](const Scene &at) {
         const auto weights = at.weights();
         return std::all_of(weights.begin(), weights.end(), [](const Rational &each) { return each > 0; });
       }},
      {"on the edge {edge}",
       [](const Scene &at, const Said &said) { return isOnEdge(at.weights(), said.at("edge")); }},
      {"at the corner {corner}",
       [](const Scene &at, const Said &said) { return isAtCorner(at.weights(), said.at("corner")); }},
  });
}

/// Of a point that may be anywhere in the plane.
template <class Scene> [[nodiscard]] Claims placeClaims() {
  return together({hitPlaceClaims<Scene>(), claimsAbout<Scene>({{"outside the triangle", [](const Scene &at) {
                                                                   return isOutside(at.weights());
                                                                 }}})});
}

/// Whether the corners that a sentence calls `first` and `second` are the same point.
[[nodiscard]] bool areSamePoint(const TriangleCorners &at, const Said &said);

/// Corners that are the same point.
[[nodiscard]] Claims coincidenceClaims();

/// What is said of u × v.
[[nodiscard]] Claims crossProductClaims();

/// What is said instead of u⊥ and v⊥ where they vanish.
[[nodiscard]] Claims zeroPerpClaims();

/// Of the ray at a place among the objects.
[[nodiscard]] Claims zeroDirectionClaims(std::size_t ray);

} // namespace halfspace::test
