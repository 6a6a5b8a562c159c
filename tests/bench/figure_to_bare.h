// A lesson's picture for the yardstick.
#pragma once

#include "tests/bench/bare_scene.h"
#include "widgets/picture/labels/label_setter.h"
#include "widgets/picture/scene_content.h"
#include "widgets/picture/view.h"

namespace halfspace::bench {

/// What the content shows, with the same sizes, colours and label pictures, but labels stand right at their
/// anchors and the tools are simpler.
[[nodiscard]] BarePicture bareOf(const SceneContent &content, const Theme &theme, const View &view,
                                 const LabelSetter &set, const LabelPainter &paint);

} // namespace halfspace::bench
