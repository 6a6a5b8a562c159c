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
[[nodiscard]] inline bool isInside(const std::array<Rational, 3> &weights) {
  return *std::min_element(weights.begin(), weights.end()) > 0;
}
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

/// Sentences about a point in a triangle: inside, on the edge {edge}, at the corner {corner}. Each says too
/// that the condition holds, and only where it does `Scene` has the weights of the point.
template <class Scene>
[[nodiscard]] Claims placeClaims(bool (*holds)(const Scene &), const char *inside, const char *onEdge,
                                 const char *atCorner) {
  return claimsAbout<Scene>({
      {inside, [holds](const Scene &at) { return holds(at) && isInside(at.weights()); }},
      {onEdge, [holds](const Scene &at,
                       const Said &said) { return holds(at) && isOnEdge(at.weights(), said.at("edge")); }},
      {atCorner,
       [holds](const Scene &at, const Said &said) {
         return holds(at) && isAtCorner(at.weights(), said.at("corner"));
       }},
  });
}

/// Whether the corners that a sentence calls `first` and `second` are the same point.
[[nodiscard]] bool areSamePoint(const TriangleCorners &at, const Said &said);

/// Sentences about corners that are the same point: two of them, or all three. They may say something else
/// besides.
[[nodiscard]] Claims coincidenceClaims(
    const char *two, const char *three,
    const std::function<bool(const TriangleCorners &, const Said &)> &besides =
        [](const TriangleCorners &, const Said &) { return true; });

/// What is said of u × v.
[[nodiscard]] Claims crossProductClaims();

/// What is said instead of u⊥ and v⊥ where they vanish.
[[nodiscard]] Claims zeroPerpClaims();

/// Of the ray at a place among the objects.
[[nodiscard]] Claims zeroDirectionClaims(std::size_t ray);

} // namespace halfspace::test
