// Shapes to triangles, for whoever draws with a depth buffer.
#pragma once

#include "widgets/picture/shapes/mesh.h"
#include "widgets/picture/shapes/shape.h"

namespace halfspace {

/// Lines, arrows, balls and faces as one opaque mesh, in their order; nothing of other shapes.
[[nodiscard]] Mesh meshOf(const std::vector<Shape> &shapes);

} // namespace halfspace
