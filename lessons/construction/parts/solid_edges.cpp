#include "lessons/construction/parts/solid_edges.h"

#include "geometry/intersect_ray_solid.h"

#include <algorithm>

namespace halfspace {

std::vector<SolidEdge> edgesOf(const Naming &naming, const Given<SolidObject> &solid,
                               const Line<Rational> &line) {
  std::vector<SolidEdge> edges;
  const auto &[vertices, faces] = solid.object.mesh;
  const std::vector<FaceEdge> sides = edgesByEnds(faces);
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2) { // each edge has two sides, one behind the other
    const auto &[from, to, face] = sides[i];
    const Line<Rational> edge = lineThrough(vertices[from], vertices[to]);
    edges.push_back({edgeTerms(naming, edges.size(), edge, permutedInnerProduct(line, edge),
                               cornerTerm(solid, from), wayTerm(solid, from, to)),
                     from, to, face, sides[i + 1].face});
  }
  return edges;
}

std::vector<FaceSide> sidesOf(const SolidMesh<Rational> &mesh, std::size_t face,
                              const std::vector<SolidEdge> &edges) {
  const auto &corners = mesh.faces[face];
  std::vector<FaceSide> sides;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto ends = std::minmax(corners[i], corners[(i + 1) % corners.size()]);
    const SolidEdge &edge = *std::find_if(edges.begin(), edges.end(), [&](const SolidEdge &each) {
      return std::minmax(each.from, each.to) == ends;
    });
    sides.push_back(edge.from == corners[i] ? FaceSide{edge.e, edge.p} : FaceSide{-edge.e, -edge.p});
  }
  return sides;
}

int sideCount(const SolidMesh<Rational> &mesh) {
  std::size_t count = 0;
  for (const auto &face : mesh.faces)
    count += face.size();
  return static_cast<int>(count);
}

FacePart partOf(std::size_t face, const std::vector<SolidEdge> &edges) {
  // A face that is convex has two edges that the line meets at a corner alone.
  const auto zeros = std::count_if(edges.begin(), edges.end(), [face](const SolidEdge &edge) {
    return edge.isOf(face) && edge.product == 0;
  });
  return zeros == 0 ? FacePart::Interior : zeros == 1 ? FacePart::Edge : FacePart::Vertex;
}

} // namespace halfspace
