// Polygons whose corners do not lie in one plane.
#pragma once

#include "lessons/object/kinds/polygon.h"

namespace halfspace {

/// The polygon with all corners moved straight into the plane of the first ones. Requires corners that do not
/// lie in one plane.
[[nodiscard]] PolygonObject flattenedPolygon(PolygonObject polygon);

} // namespace halfspace
