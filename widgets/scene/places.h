// What all code about places needs.
#pragma once

#include "lessons/figure.h"

#include <cmath>

namespace halfspace {

[[nodiscard]] inline bool isFinite(Place p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

} // namespace halfspace
