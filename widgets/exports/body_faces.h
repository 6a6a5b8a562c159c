// Bodies as flat faces among the others.
#pragma once

#include "widgets/exports/paper.h"

namespace halfspace {

/// The faces of a list with the triangles of its bodies, opaque and shaded, in an order in which they can be
/// painted. Where there are more triangles than can be cut and ordered one by one they come first, the
/// farthest of them before all others; of very many only some are drawn.
[[nodiscard]] std::vector<Shape> facesWithBodies(const ShapeList &list, const Paper &paper);

} // namespace halfspace
