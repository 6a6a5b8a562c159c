// Meshes, faces and grids as VTK has them: every corner with its colour, nothing lost.
#include "widgets/scene/vtk_mesh.h"

#include <gtest/gtest.h>

#include <vtkCell.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <array>

namespace halfspace {
namespace {

const Color red{255, 0, 0};
const Color blue{0, 0, 255};

/// A square of two triangles, red at its first corner and blue at the others.
Mesh squareMesh() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.5F}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.colors = {red, blue, blue, blue};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

Shape squareFace(Color color, double opacity) {
  return {"", color, FaceShape{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, opacity}};
}

std::array<int, 4> colorAt(vtkPolyData *data, vtkIdType point) {
  std::array<int, 4> rgba{0, 0, 0, 255};
  vtkDataArray *colors = data->GetPointData()->GetScalars();
  for (int i = 0; i < colors->GetNumberOfComponents(); ++i)
    rgba[static_cast<std::size_t>(i)] = static_cast<int>(colors->GetComponent(point, i));
  return rgba;
}

Place placeAt(vtkPolyData *data, vtkIdType point) {
  const double *at = data->GetPoint(point);
  return {at[0], at[1], at[2]};
}

TEST(VtkMesh, OfTriangles_HasTheirCornersNormalsAndColours) {
  vtkNew<vtkPolyData> data;
  MeshWriter(data).write(squareMesh());
  ASSERT_EQ(data->GetNumberOfPoints(), 4);
  ASSERT_EQ(data->GetNumberOfCells(), 2);
  EXPECT_EQ(placeAt(data, 3), Place(0, 1, 0.5));
  EXPECT_EQ(colorAt(data, 0), (std::array{255, 0, 0, 255}));
  EXPECT_EQ(colorAt(data, 2), (std::array{0, 0, 255, 255}));
  EXPECT_EQ(data->GetPointData()->GetNormals()->GetComponent(1, 2), 1);
  const std::array<vtkIdType, 3> second{0, 2, 3};
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(data->GetCell(1)->GetPointId(i), second[static_cast<std::size_t>(i)]);
}

TEST(VtkMesh, OfOneTriangleInThree_BeginsWithTheFirst) {
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
  vtkNew<vtkPolyData> data;
  write(mesh, 3, data);
  ASSERT_EQ(data->GetNumberOfCells(), 2);
  EXPECT_EQ(data->GetCell(0)->GetPointId(2), 2);
  EXPECT_EQ(data->GetCell(1)->GetPointId(0), 1);
  write(mesh, 1, data);
  EXPECT_EQ(data->GetNumberOfCells(), 4);
}

TEST(VtkMesh, WrittenAgain_HoldsOnlyWhatIsNew) {
  vtkNew<vtkPolyData> data;
  MeshWriter writer(data);
  writer.write(squareMesh());
  writer.write(Mesh());
  EXPECT_EQ(data->GetNumberOfPoints(), 0);
  EXPECT_EQ(data->GetNumberOfCells(), 0);
  const vtkMTimeType before = data->GetMTime();
  writer.write(squareMesh());
  EXPECT_EQ(data->GetNumberOfPoints(), 4);
  EXPECT_EQ(data->GetNumberOfCells(), 2);
  EXPECT_EQ(data->GetCell(1)->GetPointId(2), 3);
  EXPECT_GT(data->GetMTime(), before) << "it is drawn anew";
}

TEST(VtkFaces, InTheirOrder_HaveTheirColoursAndOpacities) {
  const Shape back = squareFace(red, 0.5);
  const Shape front = squareFace(blue, 2); // denser than can be
  vtkNew<vtkPolyData> data;
  writeFaces({back, front}, data);
  ASSERT_EQ(data->GetNumberOfCells(), 2);
  ASSERT_EQ(data->GetNumberOfPoints(), 8) << "each face has corners of its own";
  EXPECT_EQ(data->GetCell(0)->GetNumberOfPoints(), 4);
  EXPECT_EQ(colorAt(data, data->GetCell(0)->GetPointId(0)), (std::array{255, 0, 0, 128}));
  EXPECT_EQ(colorAt(data, data->GetCell(1)->GetPointId(0)), (std::array{0, 0, 255, 255}));
  writeFaces({front, back}, data);
  EXPECT_EQ(colorAt(data, data->GetCell(0)->GetPointId(0)), (std::array{0, 0, 255, 255}));
}

TEST(VtkHairlines, FadeByTheirStrengths) {
  vtkNew<vtkPolyData> data;
  writeHairlines({{"", red, HairlineShape{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {0, 1, 0.5}}},
                  {"", blue, HairlineShape{{{0, 5, 0}, {1, 5, 0}}, {1, 1}}}},
                 data);
  ASSERT_EQ(data->GetNumberOfCells(), 2);
  EXPECT_EQ(data->GetCell(0)->GetNumberOfPoints(), 3);
  EXPECT_EQ(colorAt(data, 0), (std::array{255, 0, 0, 0}));
  EXPECT_EQ(colorAt(data, 1), (std::array{255, 0, 0, 255}));
  EXPECT_EQ(colorAt(data, 2), (std::array{255, 0, 0, 128}));
  EXPECT_EQ(colorAt(data, 3), (std::array{0, 0, 255, 255}));
}

} // namespace
} // namespace halfspace
