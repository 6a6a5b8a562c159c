#include "lessons/object/kinds/point.h"
#include "tests/lessons/construction/expected/sphere_through.h"

namespace halfspace::test {
namespace {

FourPoints pointsOf(Objects objects) {
  FourPoints points;
  for (std::size_t i = 0; i < points.size(); ++i)
    points.at(i) = objectAs<PointObject>(*objects[i])->at;
  return points;
}

Recomputed recompute(Objects objects) {
  return recomputeSphereThrough(pointsOf(objects), {"A", "B", "C", "D"});
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) { return wrongAnswersThrough(pointsOf(objects)); }

} // namespace

namespace expected {

Expected circumsphere_points() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
