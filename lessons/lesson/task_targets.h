// What a step asks for as targets of the hand.
#pragma once

#include "lessons/lesson/lesson.h"
#include "lessons/scene/snap_targets.h"

namespace halfspace {

/// Where a handle makes the numbers true that tasks ask for: `signed_distance = 5`, `t = 0`, `foot.z = 0`.
///
/// A number that does not depend on the handle, or not in proportion to its way, gives no target; what is of
/// that sort and matters to learners (parallel, perpendicular, through an edge) the kinds of objects offer.
/// The several numbers of one task are one target. A place counts where the scene, evaluated there, has
/// exactly these numbers.
[[nodiscard]] std::vector<SnapTarget> taskTargets(const std::vector<Task> &tasks, const Scene &scene,
                                                  const Handle &handle);

} // namespace halfspace
