// When and where a flying saucer fires, by the number of the frame.
#pragma once

#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/ufo.h"

namespace halfspace {

/// A second has so many frames.
inline constexpr int framesPerSecond = 25;
/// In so many frames the saucer flies once its velocity.
inline constexpr int framesPerVelocity = 100;
/// In so many frames a torpedo flies once its direction: λ grows by 1.
inline constexpr int framesPerLambda = 50;
/// Firing by itself, it fires once in so many frames.
inline constexpr int framesPerShot = 150;

/// What the saucer fires last before a frame.
struct Shot {
  Rational number; ///< counted from 0
  Rational frame;  ///< in which it is fired
};

/// With the seed 0 there is one shot, in frame 0 and by hand. With another it fires by itself.
[[nodiscard]] Shot shotAt(const Rational &frame, const Rational &seed);

/// Where the barrel points for a shot that is fired by itself: it looks random, always downwards, and is the
/// same whenever seed and shot are.
[[nodiscard]] ExactVec3 randomBarrel(const Rational &seed, const Shot &shot);

/// The parameter at which the torpedo of a shot is in a frame.
[[nodiscard]] inline Rational parameterAt(const Rational &frame, const Shot &shot) {
  return (frame - shot.frame) / framesPerLambda;
}

} // namespace halfspace
