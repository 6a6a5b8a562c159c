// When and where a flying saucer fires, by the number of the frame.
#pragma once

#include "lessons/object/number.h"
#include "lessons/object/ufo.h"

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
  Rational number;  ///< counted from 0
  Rational frame;   ///< in which it is fired
  ExactVec3 barrel; ///< where the barrel points then
};

/// With the seed 0 there is one shot, in frame 0 and along the barrel. With another it fires by itself, in
/// directions that look random, all downwards, and are the same whenever the seed is.
[[nodiscard]] Shot shotAt(const Rational &frame, const Rational &seed, const ExactVec3 &barrel);

/// The parameter at which the torpedo of a shot is in a frame.
[[nodiscard]] inline Rational parameterAt(const Rational &frame, const Shot &shot) {
  return (frame - shot.frame) / framesPerLambda;
}

} // namespace halfspace
