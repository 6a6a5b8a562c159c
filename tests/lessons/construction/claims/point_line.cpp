#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/point.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

namespace halfspace::test {
namespace {

struct PointAtLine {
  explicit PointAtLine(Objects objects)
      : Q(objectAs<PointObject>(*objects[0])->at), g(objectAs<LineObject>(*objects[1]).value()) {}

  bool isLine() const { return !vanishes(g.direction); }
  bool isOnLine() const { return vanishes(perpendicular(ExactVec3(Q - g.point), g.direction)); }

  ExactVec3 Q;
  LineObject g;
};

bool isLine(const PointAtLine &at) { return at.isLine(); }

} // namespace

namespace claims {

Claims point_line() {
  return claimsAbout<PointAtLine>({
      {"{Q} is beside the line {g}: {distance}.",
       [](const PointAtLine &at) { return at.isLine() && !at.isOnLine(); }},
      {"{Q} lies on the line {g}, and is its own foot.",
       [](const PointAtLine &at) { return at.isLine() && at.isOnLine(); }},
      {"The direction {v} is the zero vector: it points nowhere, so there is no line.",
       [](const PointAtLine &at) { return !at.isLine(); }},
      {"distance", always}, // in {distance}
      {"From {A} to {Q}.", always},
      {"It takes this many steps {v} to get from {A} to the foot: there the part of w along {v} ends.",
       isLine},
      {"The foot: the line's point nearest to {Q}.", isLine},
      {"From the foot to {Q}. It is perpendicular to the line: its dot product with {v} is 0.", isLine},
      {"The distance is the length of this arrow.", isLine},
  });
}

} // namespace claims
} // namespace halfspace::test
