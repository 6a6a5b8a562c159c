// Whole points of planes, triangles, lines and faces, for others to aim at.
#pragma once

#include "lessons/lesson/new_numbers/dice.h"
#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/triangle.h"

#include <glm/vec2.hpp>

#include <vector>

namespace halfspace {

/// From `at`, some of the steps.
struct Net {
  ExactVec3 at{};
  std::vector<ExactVec3> steps;
  ExactVec3 normal{}; ///< of a line an arrow across it
  int size = 0;       ///< of a triangle or face: so many steps are its sides; 0 for planes, lines and screens

  [[nodiscard]] ExactVec3 after(const std::vector<int> &counts) const;
};

[[nodiscard]] Net netOf(const PlaneObject &plane);
/// Requires corners that are not on one line.
[[nodiscard]] Net netOf(const TriangleObject &triangle);
[[nodiscard]] Net netOf(const LineObject &line);

/// Any point of it. Of a triangle's net every second one is inside.
[[nodiscard]] ExactVec3 anyPointOf(const Net &net, Dice &dice);
/// Not the point that is given already.
[[nodiscard]] ExactVec3 pointOf(const Net &net, Dice &dice);
/// Of a triangle's net.
[[nodiscard]] ExactVec3 cornerOf(const Net &net, Dice &dice);
/// Not 0.
[[nodiscard]] ExactVec3 directionAlong(const Net &net, Dice &dice);

/// Two coordinates of the normal, changed places and one sign: a step along the plane, perhaps none.
[[nodiscard]] ExactVec3 stepAlong(const ExactVec3 &normal, int from, int to);

[[nodiscard]] bool isOnALine(const TriangleObject &triangle);

/// A convex face of three to eight corners, in steps along two directions. It has (1, 1) inside.
using WholeFace = std::vector<glm::ivec2>;
[[nodiscard]] const WholeFace &wholeFace(std::size_t corners);

} // namespace halfspace
