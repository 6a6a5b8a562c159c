// What of a lesson or a file can be drawn, as a command asks for it.
#pragma once

#include "app/batch/figure_plan.h"
#include "app/command_line.h"
#include "app/open_session.h"

namespace halfspace {

/// What a command asks for of a subject, without the steps that its lesson does not have. A sentence where it
/// has none of them, or not the frames, and where a column of the rows (null: there are none) names none of
/// its coordinates and fills no name.
[[nodiscard]] Result<PlannedSubject> plannedOf(const std::string &subject, const OpenedSession &opened,
                                               const RenderCommand &command, const ValueRows *rows);

/// Why some of the steps that a command asks for are not there; nothing where all are.
[[nodiscard]] std::optional<Problem> lackOfSteps(const OpenedSession &opened, const RenderCommand &command);

} // namespace halfspace
