// From a flat picture to a drawing.
#pragma once

#include "widgets/exports/drawing.h"
#include "widgets/exports/paper_look.h"
#include "widgets/picture/labels/label_setter.h"
#include "widgets/picture/scene_content.h"

namespace halfspace {

/// The drawing of what is laid flat, seen from a fitted view. There nothing is hidden. Title and description
/// are for the caller to say.
[[nodiscard]] Drawing flatDrawingOf(const SceneContent &content, const Theme &theme, const View &view,
                                    const PaperLook &look, const LabelSetter &set);

} // namespace halfspace
