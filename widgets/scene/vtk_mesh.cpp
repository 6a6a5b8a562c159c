#include "widgets/scene/vtk_mesh.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

namespace halfspace {
namespace {

/// Makes an array of three numbers a tuple hold these values.
template <class Array, class Value> void fill(Array &array, const std::vector<Value> &values) {
  static_assert(std::is_trivially_copyable_v<Value> &&
                sizeof(Value) == 3 * sizeof(typename Array::ValueType));
  array.SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  if (!values.empty())
    std::memcpy(array.GetVoidPointer(0), values.data(), values.size() * sizeof(Value));
  array.Modified();
}

/// Makes them say one in `stride` of triangles that are three numbers of corners each.
template <class Triangles>
void fillTriangles(vtkTypeInt32Array &offsets, vtkTypeInt32Array &connectivity, const Triangles &triangles,
                   std::size_t stride = 1) {
  static_assert(sizeof(triangles.front()) == 3 * sizeof(vtkTypeInt32));
  const std::size_t count = (triangles.size() + stride - 1) / stride;
  offsets.SetNumberOfValues(static_cast<vtkIdType>(count + 1));
  for (std::size_t i = 0; i <= count; ++i)
    offsets.SetValue(static_cast<vtkIdType>(i), static_cast<vtkTypeInt32>(3 * i));
  offsets.Modified();
  connectivity.SetNumberOfValues(static_cast<vtkIdType>(3 * count));
  vtkTypeInt32 *corner = connectivity.GetPointer(0);
  for (std::size_t i = 0; i < count; ++i)
    corner = std::copy_n(&triangles[i * stride][0], 3, corner);
  connectivity.Modified();
}

/// Points with a colour and an opacity each, gathered one by one.
struct ColoredPoints {
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedCharArray> colors;

  ColoredPoints() { colors->SetNumberOfComponents(4); }

  vtkIdType add(Place at, Color color, double opacity) {
    const std::uint8_t rgba[4] = {
        color.red, color.green, color.blue,
        static_cast<std::uint8_t>(std::lround(255 * std::clamp(opacity, 0.0, 1.0)))};
    colors->InsertNextTypedTuple(rgba);
    return points->InsertNextPoint(at.x, at.y, at.z);
  }
};

} // namespace

MeshWriter::MeshWriter(vtkPolyData *data) : m_data(data) {
  m_positions->SetNumberOfComponents(3);
  m_normals->SetNumberOfComponents(3);
  m_colors->SetNumberOfComponents(3);
  vtkNew<vtkPoints> points;
  points->SetData(m_positions);
  m_data->SetPoints(points);
  m_data->GetPointData()->SetNormals(m_normals);
  m_data->GetPointData()->SetScalars(m_colors);
}

MeshWriter::~MeshWriter() = default;

void MeshWriter::write(const Mesh &mesh) {
  fill(*m_positions, mesh.positions);
  fill(*m_normals, mesh.normals);
  fill(*m_colors, mesh.colors);
  fillTriangles(*m_offsets, *m_connectivity, mesh.triangles);
  vtkNew<vtkCellArray> cells;
  cells->SetData(m_offsets, m_connectivity);
  m_data->SetPolys(cells);
  m_data->GetPoints()->Modified();
}

void write(const TriangleMesh &mesh, std::size_t stride, vtkPolyData *data) {
  vtkNew<vtkFloatArray> corners;
  corners->SetNumberOfComponents(3);
  fill(*corners, std::vector<glm::vec3>(mesh.corners.begin(), mesh.corners.end()));
  vtkNew<vtkPoints> points;
  points->SetData(corners);
  data->SetPoints(points);
  vtkNew<vtkTypeInt32Array> offsets;
  vtkNew<vtkTypeInt32Array> connectivity;
  fillTriangles(*offsets, *connectivity, mesh.triangles, stride);
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  data->SetPolys(cells);
}

void writeFaces(const std::vector<Shape> &shapes, vtkPolyData *data) {
  ColoredPoints corners;
  vtkNew<vtkCellArray> polygons;
  forEach<FaceShape>(shapes, [&](const Shape &shape, const FaceShape &face) {
    polygons->InsertNextCell(static_cast<int>(face.corners.size()));
    for (const Place &corner : face.corners)
      polygons->InsertCellPoint(corners.add(corner, shape.color, face.opacity));
  });
  data->SetPoints(corners.points);
  data->SetPolys(polygons);
  data->GetPointData()->SetScalars(corners.colors);
}

void writeHairlines(const std::vector<Shape> &shapes, vtkPolyData *data) {
  ColoredPoints points;
  vtkNew<vtkCellArray> lines;
  forEach<HairlineShape>(shapes, [&](const Shape &shape, const HairlineShape &line) {
    lines->InsertNextCell(static_cast<int>(line.path.size()));
    for (std::size_t i = 0; i < line.path.size(); ++i)
      lines->InsertCellPoint(points.add(line.path[i], shape.color, line.strengths[i]));
  });
  data->SetPoints(points.points);
  data->SetLines(lines);
  data->GetPointData()->SetScalars(points.colors);
}

} // namespace halfspace
