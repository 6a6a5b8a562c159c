// What can be done with a handle, in words.
#pragma once

#include "widgets/picture/hand/handle_drag.h"

#include <QString>

namespace halfspace {

/// A handle that moves in this mode, from where it is seen; or that cannot be moved from there.
[[nodiscard]] QString hintOf(const Handle &handle, std::optional<DragMode> mode, const Camera &camera);
/// Nothing is selected, and the hand has not dragged much yet.
[[nodiscard]] QString firstHint();
/// Nothing is selected, and the axes are not on the stage.
[[nodiscard]] QString noAxesHint();
/// What was typed cannot be seen.
[[nodiscard]] QString typedAwayHint();
/// An object has as many corners as there can be, or as few.
[[nodiscard]] QString mostCornersHint(int count);
[[nodiscard]] QString fewestCornersHint(int count);

} // namespace halfspace
