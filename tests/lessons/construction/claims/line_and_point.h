// A line and a point, as several constructions look at them.
#pragma once

#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/point.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

namespace halfspace::test {

struct LineAndPoint {
  /// A line, the first object, and a point, the second.
  explicit LineAndPoint(Objects objects)
      : g(objectAs<LineObject>(*objects[0]).value()), Q(objectAs<PointObject>(*objects[1])->at),
        way(Q - g.point) {}

  bool isLine() const { return !vanishes(g.direction); }
  /// The point with the line's direction spans an area.
  bool isBeside() const { return !vanishes(perpendicular(way, g.direction)); }
  bool isOnLine() const { return isLine() && !isBeside(); }

  LineObject g;
  ExactVec3 Q;
  ExactVec3 way;
};

inline bool isLine(const LineAndPoint &at) { return at.isLine(); }
inline bool isBeside(const LineAndPoint &at) { return at.isBeside(); }
inline bool isOnLine(const LineAndPoint &at) { return at.isOnLine(); }

/// Of the case of a line without a direction.
[[nodiscard]] inline Claims zeroLineClaims() {
  return claimsAbout<LineAndPoint>(
      {{"The direction {v} is the zero vector: it points nowhere, so there is no line.",
        [](const LineAndPoint &at) { return !at.isLine(); }}});
}

} // namespace halfspace::test
