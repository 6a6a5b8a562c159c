// The frames of a lesson's flight, as figures show them.
#pragma once

#include "app/open_session.h"

#include <optional>

namespace halfspace {

/// The last step that shows the lesson's flight; null where it has none.
[[nodiscard]] const LessonStep *stepOfFlight(const OpenedSession &opened);

/// Puts the scene at the first frame of its flight, where it has one.
void goToFirstFrame(OpenedSession &opened);
/// Puts the scene at a frame of its flight, or at the one that is nearest; why that is not the wanted one.
[[nodiscard]] std::optional<Problem> goToFrame(int wanted, OpenedSession &opened);

} // namespace halfspace
