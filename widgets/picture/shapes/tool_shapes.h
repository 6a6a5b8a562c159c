// What is drawn for the hand: gizmo, knobs and the drop line. All of constant size on the screen.
#pragma once

#include "widgets/picture/scene_content.h"
#include "widgets/picture/shapes/shape.h"
#include "widgets/picture/view.h"

namespace halfspace {

[[nodiscard]] std::vector<Shape> toolsOf(const SceneContent &content, const Theme &theme, const View &view);

} // namespace halfspace
