// From plain meshes to VTK.
#pragma once

#include "geometry/triangle_mesh.h"
#include "widgets/picture/shapes/mesh.h"
#include "widgets/picture/shapes/shape.h"

#include <vtkNew.h>

class vtkFloatArray;
class vtkPolyData;
class vtkTypeInt32Array;
class vtkUnsignedCharArray;

namespace halfspace {

/// Makes a poly data show meshes that follow one another, triangles with normals and colours, in arrays that
/// it keeps.
class MeshWriter {
public:
  /// The data must outlive it.
  explicit MeshWriter(vtkPolyData *data);
  ~MeshWriter();
  MeshWriter(const MeshWriter &) = delete;
  MeshWriter &operator=(const MeshWriter &) = delete;

  void write(const Mesh &mesh);

private:
  vtkPolyData *m_data;
  vtkNew<vtkFloatArray> m_positions;
  vtkNew<vtkFloatArray> m_normals;
  vtkNew<vtkUnsignedCharArray> m_colors;
  vtkNew<vtkTypeInt32Array> m_offsets;
  vtkNew<vtkTypeInt32Array> m_connectivity;
};

/// Makes it show one in `stride` of triangles that share corners, without normals: each is lit as the flat
/// face that it is.
void write(const TriangleMesh &mesh, std::size_t stride, vtkPolyData *data);

/// The faces among shapes in this order, each corner with the face's colour and opacity.
void writeFaces(const std::vector<Shape> &shapes, vtkPolyData *data);

/// The hairlines among shapes, paler where they are weak: by their opacity, so that they fade into whatever
/// lies behind.
void writeHairlines(const std::vector<Shape> &shapes, vtkPolyData *data);

} // namespace halfspace
