// Faces with many corners as triangles.
#pragma once

#include "widgets/mesh_files/raw_mesh.h"

#include <cstdint>
#include <vector>

namespace halfspace {

/// Faces with more corners are cut from their first one: to cut them well takes a time that grows with the
/// square.
inline constexpr std::size_t mostCornersOfFaceCutWell = 1000;

/// Cuts faces into triangles. Kept from face to face, so that its room is made once.
class FaceCutter {
public:
  /// Adds the triangles of a face, by the numbers of its corners in the mesh. A corner that points inwards
  /// stays what it is, by cutting off ears: corners that point outwards, with no other one in their triangle.
  /// Where there is none (the face crosses itself, or has no area), where a corner is not there, and where
  /// there are too many, the rest is cut from its first corner.
  void cut(const std::vector<std::uint32_t> &face, RawMesh &mesh);

private:
  struct Corner {
    std::uint32_t number = noCorner;
    double x = 0; ///< seen along the face's normal, from where it turns left
    double y = 0;
  };

  void flatten(const std::vector<std::uint32_t> &face, const RawMesh &mesh);
  bool cutEar(RawMesh &mesh);
  [[nodiscard]] bool isEar(std::size_t at) const;
  void addFromFirst(RawMesh &mesh) const;

  /// Twice the area of a triangle, positive where it turns left.
  [[nodiscard]] static double twiceArea(const Corner &a, const Corner &b, const Corner &c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }

  std::vector<Corner> m_left; ///< the corners of what is not cut off yet
  std::size_t m_next = 0;     ///< the one that is tried next
};

} // namespace halfspace
