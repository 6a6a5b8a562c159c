// From plain meshes to VTK.
#pragma once

#include "geometry/triangle_mesh.h"
#include "widgets/picture/shapes/ground.h"
#include "widgets/picture/shapes/translucent_faces.h"

class vtkPolyData;

namespace halfspace {

/// Makes a poly data show a mesh: triangles with normals and colours.
void write(const Mesh &mesh, vtkPolyData *data);

/// Makes it show one in `stride` of triangles that share corners, without normals: each is lit as the flat
/// face that it is.
void write(const TriangleMesh &mesh, std::size_t stride, vtkPolyData *data);

/// The faces in this order, each corner with the face's colour and opacity.
void write(const std::vector<const Face *> &faces, vtkPolyData *data);

/// The grid's lines, paler where they are weak: by their opacity, so that they fade into whatever lies
/// behind.
void write(const Grid &grid, const Theme &theme, vtkPolyData *data);

} // namespace halfspace
