// A search of a mesh that can be given up while it is being made.
#pragma once

#include "geometry/search/hit_search.h"

#include <atomic>

namespace halfspace {

/// As `makeHitSearch(mesh)`; once `cancelled`, from another thread, it ends soon, and is null.
[[nodiscard]] std::unique_ptr<const HitSearch> makeHitSearch(const TriangleMesh &mesh,
                                                             const std::atomic<bool> &cancelled);

} // namespace halfspace
