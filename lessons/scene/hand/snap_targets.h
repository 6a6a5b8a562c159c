// What a dragged handle can snap to.
#pragma once

#include "lessons/object/surroundings.h"
#include "lessons/scene/hand/handles.h"

namespace halfspace {

/// The targets for a handle among the other objects of its scene, as their kinds and its own say.
[[nodiscard]] std::vector<SnapTarget> snapTargets(const PlacedScene &scene, const Handle &handle);

} // namespace halfspace
