#include "geometry/hit_search.h"

#ifdef HALFSPACE_EMBREE
#include "geometry/hit_finder.h"
#endif

namespace halfspace {

std::unique_ptr<const HitSearch> makeHitSearch(const TriangleMesh &mesh) {
#ifdef HALFSPACE_EMBREE
  // Making Embree ready takes as long as the loop needs for very many rays at so few.
  constexpr std::size_t mostWithoutTree = 64;
  if (mesh.triangles.size() > mostWithoutTree)
    return std::make_unique<const HitFinder>(trianglesOf(mesh));
#endif
  return std::make_unique<const PlainHitSearch>(mesh);
}

} // namespace halfspace
