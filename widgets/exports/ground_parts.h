// What lies below everything else of a figure: shadows on the ground, and its grid.
#pragma once

#include "widgets/exports/drawing.h"
#include "widgets/exports/paper.h"

namespace halfspace {

/// The shadows first: they lie below the grid.
[[nodiscard]] std::vector<PathPart> groundParts(const ShapeList &list, const Paper &paper);

} // namespace halfspace
