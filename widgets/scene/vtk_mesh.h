// From plain meshes to VTK.
#pragma once

#include "geometry/triangle_mesh.h"
#include "widgets/picture/shapes/mesh.h"
#include "widgets/picture/shapes/shape.h"

class vtkPolyData;

namespace halfspace {

/// Makes a poly data show a mesh: triangles with normals and colours.
void write(const Mesh &mesh, vtkPolyData *data);

/// Makes it show one in `stride` of triangles that share corners, without normals: each is lit as the flat
/// face that it is.
void write(const TriangleMesh &mesh, std::size_t stride, vtkPolyData *data);

/// The faces among shapes in this order, each corner with the face's colour and opacity.
void writeFaces(const std::vector<Shape> &shapes, vtkPolyData *data);

/// The hairlines among shapes, paler where they are weak: by their opacity, so that they fade into whatever
/// lies behind.
void writeHairlines(const std::vector<Shape> &shapes, vtkPolyData *data);

} // namespace halfspace
