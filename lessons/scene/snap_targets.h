// What a dragged handle can snap to.
#pragma once

#include "lessons/scene/flat.h"
#include "lessons/scene/handles.h"

#include <functional>

namespace halfspace {

/// The places that make something special true of the handle, and the words for it.
struct SnapTarget {
  Flat places;
  std::string name;
  /// Whether a place of the flat counts: between an edge's ends, not a zero direction. Empty: all do.
  std::function<bool(const ExactVec3 &)> counts;
};

/// The targets for a handle: positions catch at other objects' points, edges and planes; a ray's direction
/// where it is parallel to a plane, points through a vertex or an edge or along an axis; a plane's normal
/// along an axis; a plane's offset where it goes through a point.
[[nodiscard]] std::vector<SnapTarget> snapTargets(const Scene &scene, const Handle &handle);

} // namespace halfspace
