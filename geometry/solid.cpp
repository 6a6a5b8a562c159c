#include "geometry/solid.h"

#include <tuple>

namespace halfspace {

std::vector<FaceEdge> edgesByEnds(const std::vector<std::vector<std::uint32_t>> &faces) {
  std::vector<FaceEdge> edges;
  for (std::size_t face = 0; face < faces.size(); ++face)
    for (std::size_t i = 0; i < faces[face].size(); ++i)
      edges.push_back(
          {faces[face][i], faces[face][(i + 1) % faces[face].size()], static_cast<std::uint32_t>(face)});
  std::sort(edges.begin(), edges.end(), [](const FaceEdge &a, const FaceEdge &b) {
    return std::tuple(a.ends(), a.face) < std::tuple(b.ends(), b.face);
  });
  return edges;
}

bool isClosed(const std::vector<FaceEdge> &edges) {
  if (edges.size() % 2 != 0)
    return false;
  for (std::size_t i = 0; i < edges.size(); i += 2) {
    const FaceEdge &first = edges[i];
    const FaceEdge &second = edges[i + 1];
    if (first.from != second.to || first.to != second.from || first.face == second.face)
      return false;
    if (i + 2 < edges.size() && edges[i + 2].ends() == first.ends())
      return false;
  }
  return true;
}

} // namespace halfspace
