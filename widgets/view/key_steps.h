// Moving a handle with the keys.
#pragma once

#include "lessons/scene/hand/handles.h"
#include "widgets/picture/camera.h"

#include <Qt>

namespace halfspace {

/// The key for what an arrow key means to what moves up and down: there it goes along z.
[[nodiscard]] int verticalKey(int key);

/// Where a key takes a handle; nothing for a key that moves nothing. The arrow keys go along x and y as the
/// camera shows them: left and right along the one that runs most across the screen, up and down along the
/// other. Page Up and Down go along z. Shift makes a tenth of the step, Ctrl ten steps. A handle with an axis
/// of its own moves along that.
[[nodiscard]] std::optional<ExactVec3> steppedPlace(const Handle &handle, int key,
                                                    Qt::KeyboardModifiers modifiers, const Rational &step,
                                                    const Camera &camera);

} // namespace halfspace
