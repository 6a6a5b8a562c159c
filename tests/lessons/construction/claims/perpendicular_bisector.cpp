#include "lessons/object/kinds/point.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

namespace halfspace::test {
namespace {

struct TwoPoints {
  explicit TwoPoints(Objects objects)
      : A(objectAs<PointObject>(*objects[0])->at), B(objectAs<PointObject>(*objects[1])->at) {}

  ExactVec3 A, B;
};

bool areApart(const TwoPoints &at) { return at.A != at.B; }

} // namespace

namespace claims {

Claims perpendicular_bisector() {
  return claimsAbout<TwoPoints>({
      {"{E} has all points that are equally far from {A} and {B}: {distance} from the plane to each of the "
       "two.",
       areApart},
      {"{A} and {B} are the same point: every point is equally far from both, and no plane is special.",
       [](const TwoPoints &at) { return at.A == at.B; }},
      {"distance", always}, // in {distance}
      {"From {A} to {B}: the plane is perpendicular to this way.", areApart},
      {"The middle between {A} and {B}, which the plane goes through.", areApart},
      {"So that the middle fulfils the equation.", areApart},
      {"The same from |P − {A}|² = |P − {B}|² multiplied out, where P·P falls away on both sides.", areApart},
      {"A point P = (x, y, z) lies in {plane} exactly when it makes this 0.", areApart},
      {"Half of the way from {A} to {B}.", areApart},
  });
}

} // namespace claims
} // namespace halfspace::test
