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

namespace halfspace {
namespace {

vtkNew<vtkFloatArray> floatArray(const std::vector<glm::vec3> &values) {
  static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
  vtkNew<vtkFloatArray> array;
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  if (!values.empty())
    std::copy_n(&values.front().x, values.size() * 3, array->GetPointer(0));
  return array;
}

vtkNew<vtkUnsignedCharArray> colorArray(const std::vector<Color> &colors) {
  static_assert(sizeof(Color) == 3);
  vtkNew<vtkUnsignedCharArray> array;
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(colors.size()));
  if (!colors.empty())
    std::copy_n(&colors.front().red, colors.size() * 3, array->GetPointer(0));
  return array;
}

/// Of one in `stride` of triangles that are three numbers of corners each.
template <class Triangles>
vtkNew<vtkCellArray> triangleArray(const Triangles &triangles, std::size_t stride = 1) {
  static_assert(sizeof(triangles.front()) == 3 * sizeof(vtkTypeInt32));
  const std::size_t count = (triangles.size() + stride - 1) / stride;
  vtkNew<vtkTypeInt32Array> offsets;
  vtkTypeInt32 *offset = offsets->WritePointer(0, static_cast<vtkIdType>(count + 1));
  for (std::size_t i = 0; i <= count; ++i)
    offset[i] = static_cast<vtkTypeInt32>(3 * i);
  vtkNew<vtkTypeInt32Array> connectivity;
  vtkTypeInt32 *corner = connectivity->WritePointer(0, static_cast<vtkIdType>(3 * count));
  for (std::size_t i = 0; i < count; ++i)
    corner = std::copy_n(&triangles[i * stride][0], 3, corner);
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  return cells;
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

void write(const Mesh &mesh, vtkPolyData *data) {
  vtkNew<vtkPoints> points;
  points->SetData(floatArray(mesh.positions));
  data->SetPoints(points);
  data->SetPolys(triangleArray(mesh.triangles));
  data->GetPointData()->SetNormals(floatArray(mesh.normals));
  data->GetPointData()->SetScalars(colorArray(mesh.colors));
}

void write(const TriangleMesh &mesh, std::size_t stride, vtkPolyData *data) {
  const std::vector<glm::vec3> corners(mesh.corners.begin(), mesh.corners.end());
  vtkNew<vtkPoints> points;
  points->SetData(floatArray(corners));
  data->SetPoints(points);
  data->SetPolys(triangleArray(mesh.triangles, stride));
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
