// A mesh that grows as its file is read.
#pragma once

#include "widgets/mesh_files/cut_face.h"
#include "widgets/mesh_files/raw_mesh.h"

#include <cstdint>
#include <vector>

namespace halfspace {

/// Takes the corners and faces of a file, and cuts faces of more than three corners into triangles.
class MeshBuilder {
public:
  void addCorner(const Vec3<float> &corner) { m_mesh.corners.push_back(corner); }
  /// By the numbers of its corners; of fewer than three nothing comes.
  void addFace(const std::vector<std::uint32_t> &corners) { m_cutter.cut(corners, m_mesh); }

  [[nodiscard]] std::size_t cornerCount() const { return m_mesh.corners.size(); }
  [[nodiscard]] bool isTooLarge() const {
    return m_mesh.corners.size() > mostMeshCorners || m_mesh.triangles.size() > mostMeshTriangles;
  }
  /// The mesh is for the caller from then on. Corners that are not there have become `noCorner`.
  [[nodiscard]] RawMesh take();

private:
  RawMesh m_mesh;
  FaceCutter m_cutter;
};

} // namespace halfspace
