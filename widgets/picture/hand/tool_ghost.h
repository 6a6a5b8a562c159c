// What would come of a tool, as it is shown before it is there.
#pragma once

#include "widgets/picture/hand/object_tool.h"
#include "widgets/picture/stage.h"

namespace halfspace {

/// What a tool has taken and would take next as ghosts, in units of the stage: the new points, and the object
/// where that is all it wants; before, the way from point to point, which corners close where they can.
[[nodiscard]] Figure ghostOf(const ObjectTool &tool, const std::optional<ToolPick> &next,
                             const Evaluation &evaluation, const Stage &stage);

} // namespace halfspace
