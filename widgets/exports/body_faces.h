// Bodies as flat faces among the others.
#pragma once

#include "widgets/exports/paper.h"

namespace halfspace {

/// Up to so many faces are cut and ordered exactly.
inline constexpr std::size_t mostOrderedFaces = 2000;
/// No more triangles of bodies than this are drawn.
inline constexpr std::size_t mostDrawnTriangles = 20000;

/// The faces of a list with the triangles of its bodies, opaque and shaded, in an order in which they can be
/// painted. Where there are more triangles than can be ordered exactly they come first, the
/// farthest of them before all others; of very many only some are drawn.
[[nodiscard]] std::vector<Shape> facesWithBodies(const ShapeList &list, const Paper &paper);

} // namespace halfspace
