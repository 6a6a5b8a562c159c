// The parts of a view that nothing covers.
#pragma once

#include "widgets/picture/camera.h"

namespace halfspace {

/// The largest upright rectangles of a room that touch none of the covered ones, in any order: each reaches
/// on all sides to a covered one or to the room's side. They overlap one another.
[[nodiscard]] std::vector<PixelBox> freeRooms(const PixelBox &room, const std::vector<PixelBox> &covered);

} // namespace halfspace
