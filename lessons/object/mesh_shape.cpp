#include "lessons/object/mesh_shape.h"

#include <utility>

namespace halfspace {
namespace {

BoundingBox boxAround(const std::vector<Vec3<double>> &corners) {
  BoundingBox box;
  for (const Vec3<double> &corner : corners)
    box.include(corner);
  return box;
}

TriangleMesh cutIntoTriangles(std::vector<Vec3<double>> corners, const std::vector<MeshFace> &faces) {
  TriangleMesh mesh{std::move(corners), {}};
  for (const MeshFace &face : faces)
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      mesh.triangles.push_back({face[0], face[i], face[i + 1]});
  return mesh;
}

} // namespace

MeshShape::MeshShape(std::vector<Vec3<double>> corners, std::vector<MeshFace> faces)
    : m_faces(std::move(faces)),
      m_mesh(std::make_shared<const TriangleMesh>(cutIntoTriangles(std::move(corners), m_faces))),
      m_search(makeHitSearch(*m_mesh)), m_box(boxAround(m_mesh->corners)) {
  if (m_faces.size() > mostDrawnFaces)
    m_faces.clear();
}

MeshShape::MeshShape(TriangleMesh mesh, std::shared_ptr<const HitSearch> search)
    : m_mesh(std::make_shared<const TriangleMesh>(std::move(mesh))), m_search(std::move(search)),
      m_box(boxAround(m_mesh->corners)) {}

} // namespace halfspace
