// What of a lesson or a file can be drawn, as a command asks for it.
#pragma once

#include "app/batch/figure_plan.h"
#include "app/command_line.h"
#include "app/open_session.h"

namespace halfspace {

/// The steps of a subject that a command asks for. A sentence where its lesson does not have one of them, or
/// a frame, and where a column of the rows (null: there are none) names none of its coordinates and fills no
/// name.
[[nodiscard]] Result<PlannedSubject> plannedOf(const std::string &subject, const OpenedSession &opened,
                                               const RenderCommand &command, const ValueRows *rows);

} // namespace halfspace
