// The solid parts of a figure as triangles.
#pragma once

#include "tests/picture/shapes/mesh_of.h"
#include "widgets/picture/shapes/mark_shapes.h"

namespace halfspace {

inline Mesh solidMesh(const Figure &figure, const std::set<std::string> &highlighted, const Theme &theme,
                      double scale, const Arrival &arrival = {}) {
  return meshOf(solidsOf(figure, highlighted, theme, scale, arrival));
}

} // namespace halfspace
