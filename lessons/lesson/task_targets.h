// What a step asks for as targets of the hand.
#pragma once

#include "lessons/lesson/lesson.h"
#include "lessons/scene/hand/snap_targets.h"

namespace halfspace {

/// Where a handle makes the numbers true that tasks ask for: `signed_distance = 5`, `t = 0`, `distance = 3`
/// from a line.
///
/// A number that changes in proportion to the handle's way asks for a plane, and one that does so squared, or
/// whose square does, for a curved surface. Others give no target; what is of that sort and matters to
/// learners (parallel, perpendicular, through an edge, touching) the kinds of objects offer. The several
/// numbers of one task are one target. A place counts where the scene, evaluated there, has exactly these
/// numbers.
[[nodiscard]] std::vector<SnapTarget> taskTargets(const std::vector<Task> &tasks, const Scene &scene,
                                                  const Handle &handle);

} // namespace halfspace
