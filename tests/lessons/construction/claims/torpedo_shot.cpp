#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/ufo.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/torpedo_tools.h"

namespace halfspace::test {
namespace {

struct ShotOfSaucer {
  explicit ShotOfSaucer(Objects objects)
      : U(objectAs<UfoObject>(*objects[0]).value()), frame(objectAs<NumberObject>(*objects[1])->value),
        seed(objectAs<NumberObject>(*objects[2])->value), shot(lastShot(frame, seed, U.barrel)) {}

  bool isByHand() const { return seed == 0; }
  bool canFire() const { return !vanishes(shot.barrel) && U.barrelLength != 0; }
  bool hasFraction() const { return rootOf(product(shot.barrel, shot.barrel)).has_value(); }
  /// While the first shot is the last one.
  bool isFirstShot() const { return isByHand() || (frame >= 0 && frame < 150); }

  UfoObject U;
  Rational frame, seed;
  LastShot shot;
};

/// The first is fired in frame 0, each next one 150 frames later.
bool isCounted(const ShotOfSaucer &at, const Said &said) {
  const Rational number = parseRational(said.at("number")).value();
  return at.canFire() && !at.isByHand() && (number - 1) * 150 <= at.frame && at.frame < number * 150;
}

bool canFire(const ShotOfSaucer &at) { return at.canFire(); }

} // namespace

namespace claims {

Claims torpedo_shot() {
  return claimsAbout<ShotOfSaucer>({
      {"The barrel {g} is the zero vector: it points nowhere, so nothing is fired.",
       [](const ShotOfSaucer &at) { return at.isByHand() && vanishes(at.U.barrel); }},
      {"{l}: a barrel without a length gives no direction, so nothing is fired.",
       [](const ShotOfSaucer &at) { return at.U.barrelLength == 0; }},
      {"The saucer fires from {Q} along its barrel.",
       [](const ShotOfSaucer &at) { return at.canFire() && at.isByHand(); }},
      {"The saucer fires by itself. This is shot number {number}.", isCounted},
      {"The saucer fires from where it starts.",
       [](const ShotOfSaucer &at) { return at.canFire() && at.isFirstShot(); }},
      {"Where the saucer is when it fires: it flies {c} in {frames} frames.",
       [](const ShotOfSaucer &at, const Said &said) {
         return at.canFire() && !at.isFirstShot() && said.at("frames") == "100";
       }},
      {"How long the arrow is that tells where the barrel points.", canFire},
      {"Divided by its length an arrow is one unit long; times {l} it is as long as the barrel.", canFire},
      {"The direction of the torpedo.",
       [](const ShotOfSaucer &at) { return at.canFire() && at.hasFraction(); }},
      {"The direction of the torpedo. The factor is rounded to {digits} digits: so this is exactly the "
       "barrel's direction, and nearly its length.",
       [](const ShotOfSaucer &at, const Said &said) {
         return at.canFire() && !at.hasFraction() && said.at("digits") == "4";
       }},
  });
}

} // namespace claims
} // namespace halfspace::test
