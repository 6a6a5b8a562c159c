// Lines from the points of a figure down to the ground.
#pragma once

#include "lessons/figure/figure.h"

namespace halfspace {

/// Adds a dashed line from each point with a letter that is not on the ground, z = 0, to the place below or
/// above it there. It accompanies the point's mark: `Q/drop`.
void addDropLines(Figure &figure);

} // namespace halfspace
