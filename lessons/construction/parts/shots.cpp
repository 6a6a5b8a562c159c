#include "lessons/construction/parts/shots.h"

#include "geometry/integer.h"

#include <cstdint>
#include <random>

namespace halfspace {
namespace {

/// Random directions end within this square around the saucer's foot, and so far below it.
constexpr int farthestAside = 6;
constexpr int farDown = 8;

} // namespace

// The same on every machine: the engine's numbers are fixed by the standard.
ExactVec3 randomBarrel(const Rational &seed, const Shot &shot) {
  const auto wordOf = [](const Rational &number) {
    return static_cast<std::uint32_t>(toDouble(floorOf(abs(number))));
  };
  std::seed_seq mixed{wordOf(seed), wordOf(shot.number)};
  std::mt19937 engine(mixed);
  const auto aside = [&] {
    constexpr std::uint32_t choices = 2 * farthestAside + 1;
    return Rational(static_cast<int>(engine() % choices) - farthestAside);
  };
  const Rational x = aside();
  const Rational y = aside();
  return {x, y, -farDown};
}

Shot shotAt(const Rational &frame, const Rational &seed) {
  const Rational number = seed == 0 ? Rational(0) : floorOf(frame / framesPerShot);
  return {number, number * framesPerShot};
}

} // namespace halfspace
