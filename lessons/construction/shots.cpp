#include "lessons/construction/shots.h"

#include "geometry/integer.h"

#include <cstdint>
#include <random>

namespace halfspace {
namespace {

/// Random directions end within this square around the saucer's foot, and so far below it.
constexpr int farthestAside = 6;
constexpr int farDown = 8;

/// The same for the same seed and shot on every machine: the engine's numbers are fixed by the standard.
ExactVec3 randomDirection(const Rational &seed, const Rational &shot) {
  const auto wordOf = [](const Rational &number) {
    return static_cast<std::uint32_t>(toDouble(floorOf(abs(number))));
  };
  std::seed_seq mixed{wordOf(seed), wordOf(shot)};
  std::mt19937 engine(mixed);
  const auto aside = [&] {
    constexpr std::uint32_t choices = 2 * farthestAside + 1;
    return Rational(static_cast<int>(engine() % choices) - farthestAside);
  };
  const Rational x = aside();
  const Rational y = aside();
  return {x, y, -farDown};
}

} // namespace

Shot shotAt(const Rational &frame, const Rational &seed, const ExactVec3 &barrel) {
  if (seed == 0)
    return {0, 0, barrel};
  const Rational number = floorOf(frame / framesPerShot);
  return {number, number * framesPerShot, randomDirection(seed, number)};
}

} // namespace halfspace
