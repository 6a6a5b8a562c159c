#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/ray.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/torpedo_tools.h"

namespace halfspace::test {
namespace {

/// A torpedo among meshes: each triangle of each is asked by itself.
struct Flight {
  explicit Flight(Objects objects)
      : L(objectAs<RayObject>(*objects[0]).value()), frame(objectAs<NumberObject>(*objects[1])->value),
        seed(objectAs<NumberObject>(*objects[2])->value),
        lambda((frame - lastShot(frame, seed, {}).frame) / 50) {
    for (const Object *mesh : objects.subspan(3))
      for (const auto &triangle : trianglesOf(objectAs<MeshObject>(*mesh).value()))
        if (const Met met = meet({L.origin, L.direction}, triangle); met.caseName == "hit")
          first = first ? std::min(*first, *met.lambda) : met.lambda;
  }

  bool flies() const { return !vanishes(L.direction); }
  bool hits() const { return flies() && first; }
  bool hasHit() const { return hits() && lambda >= *first; }
  bool isUnderWay() const { return flies() && !hasHit() && lambda > 0; }
  bool isWaiting() const { return flies() && !hasHit() && lambda <= 0; }

  RayObject L;
  Rational frame, seed;
  Rational lambda;
  std::optional<Rational> first; ///< where it hits
};

} // namespace

namespace claims {

Claims torpedo_flight() {
  return claimsAbout<Flight>({
      {"The direction {r} is the zero vector: the ray goes nowhere.",
       [](const Flight &at) { return !at.flies(); }},
      {"The torpedo has hit {fragment}, at {lambda}.", [](const Flight &at) { return at.hasHit(); }},
      {"{lambda}: the torpedo is not fired yet. What it will hit, and when, is known already.",
       [](const Flight &at) { return at.isWaiting() && at.hits(); }},
      {"{lambda}: the torpedo is not fired yet. It will not explode.",
       [](const Flight &at) { return at.isWaiting() && !at.hits(); }},
      {"The torpedo flies, at {lambda}. What it will hit, and when, is known already.",
       [](const Flight &at) { return at.isUnderWay() && at.hits(); }},
      {"The torpedo flies, at {lambda}, and will not explode.",
       [](const Flight &at) { return at.isUnderWay() && !at.hits(); }},
      {"The torpedo has reached what it hits.", [](const Flight &at) { return at.hasHit(); }},
      {"Where the torpedo is now. Its parameter grows by 1 in {frames} frames.",
       [](const Flight &at, const Said &said) { return at.isUnderWay() && said.at("frames") == "50"; }},
      {"The torpedo is not fired yet. Once it is, its parameter grows by 1 in {frames} frames.",
       [](const Flight &at, const Said &said) { return at.isWaiting() && said.at("frames") == "50"; }},
  });
}

} // namespace claims
} // namespace halfspace::test
