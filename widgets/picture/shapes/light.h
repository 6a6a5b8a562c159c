// How what is solid in a picture is lit, whoever draws it.
#pragma once

#include "lessons/figure/mark.h"

#include <array>

namespace halfspace {

/// A light that goes with the eye.
struct CameraLight {
  Place from{}; ///< its direction from what is looked at: to the right, upwards, and towards the eye
  double strength = 0;
};

inline constexpr std::array cameraLights{CameraLight{{-0.5, 0.9, 1.0}, 0.78},
                                         CameraLight{{0.8, -0.2, 0.9}, 0.30}};

/// The part of its colour that a surface has without them …
inline constexpr double ambientPart = 0.42;
/// … and that which each adds where it falls straight on it, times its strength.
inline constexpr double diffusePart = 0.70;

} // namespace halfspace
