#include "lessons/object/kinds/tetrahedron.h"
#include "tests/lessons/construction/expected/sphere_through.h"

namespace halfspace::test {
namespace {

FourPoints cornersOf(Objects objects) {
  const auto [p0, p1, p2, p3] = objectAs<TetrahedronObject>(*objects[0]).value();
  return {p0, p1, p2, p3};
}

Recomputed recompute(Objects objects) {
  return recomputeSphereThrough(cornersOf(objects), {"P_0", "P_1", "P_2", "P_3"});
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) { return wrongAnswersThrough(cornersOf(objects)); }

} // namespace

namespace expected {

Expected circumsphere() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
