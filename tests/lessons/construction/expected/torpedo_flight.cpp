#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/ray.h"
#include "tests/lessons/construction/expected/torpedo_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

struct Given {
  RayObject ray;
  Rational elapsed; ///< the parameter by the frame
  std::optional<Rational> firstHit;
};

/// The smallest parameter of a hit.
std::optional<Rational> firstHitOf(const RayObject &ray, Objects meshes) {
  std::optional<Rational> first;
  for (const Object *object : meshes)
    for (const Triangle<Rational> &triangle : trianglesOf(objectAs<MeshObject>(*object).value())) {
      const Met met = meet({ray.origin, ray.direction}, triangle);
      if (met.caseName == "hit")
        first = first ? std::min(*first, *met.lambda) : met.lambda;
    }
  return first;
}

Given read(Objects objects) {
  const auto ray = objectAs<RayObject>(*objects[0]).value();
  const Rational frame = objectAs<NumberObject>(*objects[1])->value;
  const Rational seed = objectAs<NumberObject>(*objects[2])->value;
  return {ray, (frame - lastShot(frame, seed, {}).frame) * Rational(2, 100),
          vanishes(ray.direction) ? std::nullopt : firstHitOf(ray, objects.subspan(3))};
}

Rational lambdaOf(const Given &given) {
  return given.firstHit ? std::min(*given.firstHit, given.elapsed) : given.elapsed;
}

Recomputed recompute(Objects objects) {
  const Given given = read(objects);
  const auto &[Q, r] = given.ray;
  Recomputed expected;
  expected.degenerate = vanishes(r);
  if (expected.degenerate) {
    expected.caseName = "zero-direction";
    expected.names = {{"Q", quantity(Q)}};
    return expected;
  }
  const Rational lambda = lambdaOf(given);
  const ExactVec3 M = Q + r * lambda;
  expected.caseName = given.firstHit && given.elapsed >= *given.firstHit ? "exploded"
                      : given.elapsed <= 0                               ? "waiting"
                                                                         : "flying";
  expected.values = {{"lambda", number(lambda)}, {"place", numbers(M)}};
  expected.names = {
      {"Q", quantity(Q)}, {"\\vec r", quantity(r)}, {"\\lambda_M", quantity(lambda)}, {"M", quantity(M)}};
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const Given given = read(objects);
  std::vector<WrongAnswer> all;
  if (!vanishes(given.ray.direction))
    addPointOnRay(all, "place", given.ray.origin, lambdaOf(given), given.ray.direction);
  return all;
}

} // namespace

namespace expected {

Expected torpedo_flight() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.1};
}

} // namespace expected
} // namespace halfspace::test
