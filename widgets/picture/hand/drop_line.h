// The line from what the hand holds down to the ground.
#pragma once

#include "lessons/object/handle.h"
#include "widgets/picture/scene_content.h"

namespace halfspace {

/// Of a handle that is a place; nothing for others. While numbers are hidden a point on something has none
/// either: where it is follows from how far it has moved there, and a learner may be asked for it.
[[nodiscard]] std::optional<DropLine> dropLineOf(const Handle &handle, bool numbersHidden);

} // namespace halfspace
