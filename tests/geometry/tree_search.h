// The way to find a ray's first hit by a tree of boxes, which needs Embree.
#pragma once

#include "geometry/search/hit_finder.h"
#include "tests/geometry/every_search.h"

namespace halfspace {

inline const SearchKind treeSearch{"HitFinder", [](const TriangleMesh &mesh) -> std::unique_ptr<HitSearch> {
                                     return std::make_unique<HitFinder>(trianglesOf(mesh));
                                   }};

} // namespace halfspace
