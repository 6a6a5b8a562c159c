#include "widgets/mesh_files/cut_face.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

/// The normal of a face that need not be flat: the sum of those of the triangles from its first corner.
Vec3<double> normalOf(const std::vector<std::uint32_t> &face, const std::vector<Vec3<float>> &corners) {
  const auto place = [&](std::size_t i) { return Vec3<double>(corners[face[i]]); };
  Vec3<double> normal(0.0);
  for (std::size_t i = 1; i + 1 < face.size(); ++i)
    normal += glm::cross(place(i) - place(0), place(i + 1) - place(0));
  return normal;
}

int longestAxis(const Vec3<double> &vector) {
  int longest = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (std::abs(vector[axis]) > std::abs(vector[longest]))
      longest = axis;
  return longest;
}

} // namespace

void FaceCutter::cut(const std::vector<std::uint32_t> &face, RawMesh &mesh) {
  const bool areThere = std::all_of(face.begin(), face.end(),
                                    [&](std::uint32_t corner) { return corner < mesh.corners.size(); });
  m_left.clear();
  if (areThere && face.size() > 3 && face.size() <= mostCornersOfFaceCutWell)
    flatten(face, mesh);
  else
    for (const std::uint32_t corner : face)
      m_left.push_back({corner, 0, 0});
  m_next = 1;
  while (m_left.size() > 3 && cutEar(mesh)) {
  }
  addFromFirst(mesh);
}

void FaceCutter::flatten(const std::vector<std::uint32_t> &face, const RawMesh &mesh) {
  const Vec3<double> normal = normalOf(face, mesh.corners);
  const int along = longestAxis(normal);
  const bool isFromBehind = normal[along] < 0;
  const int x = (along + (isFromBehind ? 2 : 1)) % 3;
  const int y = (along + (isFromBehind ? 1 : 2)) % 3;
  for (const std::uint32_t corner : face)
    m_left.push_back({corner, mesh.corners[corner][x], mesh.corners[corner][y]});
}

bool FaceCutter::cutEar(RawMesh &mesh) {
  const std::size_t count = m_left.size();
  for (std::size_t tried = 0; tried < count; ++tried, ++m_next) {
    const std::size_t at = m_next % count;
    if (!isEar(at))
      continue;
    mesh.triangles.push_back(
        {m_left[(at + count - 1) % count].number, m_left[at].number, m_left[(at + 1) % count].number});
    m_left.erase(m_left.begin() + static_cast<std::ptrdiff_t>(at));
    m_next = at + 1; // beside it, so that the pieces do not all meet in one corner
    return true;
  }
  return false;
}

bool FaceCutter::isEar(std::size_t at) const {
  const std::size_t count = m_left.size();
  const Corner &before = m_left[(at + count - 1) % count];
  const Corner &tip = m_left[at];
  const Corner &after = m_left[(at + 1) % count];
  if (!(twiceArea(before, tip, after) > 0))
    return false;
  const auto isCorner = [&](const Corner &other) {
    return other.number == before.number || other.number == tip.number || other.number == after.number;
  };
  return std::none_of(m_left.begin(), m_left.end(), [&](const Corner &other) {
    return !isCorner(other) && twiceArea(before, tip, other) >= 0 && twiceArea(tip, after, other) >= 0 &&
           twiceArea(after, before, other) >= 0;
  });
}

void FaceCutter::addFromFirst(RawMesh &mesh) const {
  for (std::size_t i = 1; i + 1 < m_left.size(); ++i)
    mesh.triangles.push_back({m_left[0].number, m_left[i].number, m_left[i + 1].number});
}

} // namespace halfspace
