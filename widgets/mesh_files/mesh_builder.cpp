#include "widgets/mesh_files/mesh_builder.h"

#include <utility>

namespace halfspace {

RawMesh MeshBuilder::take() {
  for (auto &triangle : m_mesh.triangles)
    for (std::uint32_t &corner : triangle)
      if (corner >= m_mesh.corners.size())
        corner = noCorner;
  return std::exchange(m_mesh, {});
}

} // namespace halfspace
