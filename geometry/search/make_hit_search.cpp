#include "geometry/search/make_hit_search.h"

#ifdef HALFSPACE_EMBREE
#include "geometry/search/hit_finder.h"
#endif

namespace halfspace {

std::unique_ptr<const HitSearch> makeHitSearch(const TriangleMesh &mesh) {
  const std::atomic<bool> never = false;
  return makeHitSearch(mesh, never);
}

std::unique_ptr<const HitSearch> makeHitSearch(const TriangleMesh &mesh, const std::atomic<bool> &cancelled) {
  std::unique_ptr<const HitSearch> search;
#ifdef HALFSPACE_EMBREE
  // Making Embree ready takes as long as the loop needs for very many rays at so few.
  constexpr std::size_t mostWithoutTree = 64;
  if (mesh.triangles.size() > mostWithoutTree)
    search = std::make_unique<const HitFinder>(trianglesOf(mesh), &cancelled);
#endif
  if (!search)
    search = std::make_unique<const PlainHitSearch>(mesh);
  return cancelled ? nullptr : std::move(search);
}

} // namespace halfspace
