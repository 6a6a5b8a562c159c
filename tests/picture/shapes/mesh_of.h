// The mesh of one list of shapes.
#pragma once

#include "widgets/picture/shapes/shape_mesh.h"

#include <memory>
#include <utility>

namespace halfspace {

inline Mesh meshOf(std::vector<Shape> shapes) {
  return MeshSequence().meshOf(std::make_shared<const std::vector<Shape>>(std::move(shapes)));
}

} // namespace halfspace
