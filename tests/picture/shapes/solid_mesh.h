// The solid parts of a figure as triangles.
#pragma once

#include "widgets/picture/shapes/mark_shapes.h"
#include "widgets/picture/shapes/shape_mesh.h"

namespace halfspace {

inline Mesh solidMesh(const Figure &figure, const std::set<std::string> &highlighted, const Theme &theme,
                      double scale, const Arrival &arrival = {}) {
  return meshOf(solidsOf(figure, highlighted, theme, scale, arrival));
}

} // namespace halfspace
