// The frames of a lesson's flight, as figures show them.
#pragma once

#include "app/open_session.h"

#include <optional>

namespace halfspace {

/// The last step that shows the lesson's flight; null where it has none.
[[nodiscard]] const LessonStep *stepOfFlight(const OpenedSession &opened);

/// Puts the scene at the first frame of its flight. Requires one.
void goToFirstFrame(OpenedSession &opened);
/// Puts the scene at the frame that is nearest to the wanted one, and returns that. Requires a flight.
Rational goToFrame(int wanted, OpenedSession &opened);

/// Why a scene has no such frame; nothing where it has.
[[nodiscard]] std::optional<Problem> refuseFrame(int frame, OpenedSession opened);

} // namespace halfspace
