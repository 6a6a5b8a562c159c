// Shapes to triangles, for whoever draws with a depth buffer.
#pragma once

#include "widgets/picture/shapes/mesh.h"
#include "widgets/picture/shapes/shape_list.h"

namespace halfspace {

/// The meshes of lists that follow one another, as in a drag: a shape that is the same as in the list before,
/// at the same place in it, has its part of the mesh already, and the memory of two meshes serves for all.
class MeshSequence {
public:
  /// Lines, arrows, balls and faces as one opaque mesh, in their order; nothing of other shapes. Valid until
  /// the next list.
  const Mesh &meshOf(const ShapeLayer &shapes);

private:
  /// Where a shape's part of the mesh begins.
  struct Begin {
    std::size_t corner;
    std::size_t triangle;
  };
  /// A mesh with the shapes that it is of; there is one more begin than shapes.
  struct Made {
    ShapeLayer shapes = std::make_shared<const std::vector<Shape>>();
    std::vector<Begin> begins;
    Mesh mesh;
  };

  /// The part of the mesh before that a shape of it has.
  void appendBefore(std::size_t shape);

  Made m_now;
  Made m_before;
};

} // namespace halfspace
