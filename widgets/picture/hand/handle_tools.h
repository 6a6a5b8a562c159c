// The tools that are drawn for handles, and what a pointer takes hold of among them.
#pragma once

#include "lessons/scene/evaluation.h"
#include "widgets/picture/hand/grips.h"
#include "widgets/picture/hand/handle_selection.h"
#include "widgets/picture/scene_content.h"

namespace halfspace {

/// The tool of a handle that moves in this mode now, or cannot be moved from where it is seen.
[[nodiscard]] Gizmo gizmoOf(const Handle &handle, std::optional<DragMode> mode);

/// What a handle that moves one coordinate of the scene leaves as it is when it is moved in x and y: "z = 4
/// fixed", as LaTeX. Of an arrow's tip it is the arrow's own number.
[[nodiscard]] std::string fixedNote(const Handle &handle, const Scene &scene, const Evaluation &evaluation);

/// The knobs of the handles that can be grabbed from where the camera stands.
[[nodiscard]] std::vector<Knob> knobsOf(const HandleSelection &selection, const Camera &camera);

/// What lies under the pointer: a handle, or a part of the selected handle's tool, or neither.
struct Touched {
  const Handle *handle = nullptr;
  std::optional<Gizmo::Part> part{};
};

/// What a press at a pixel would take hold of: first what is seen of a handle, then a part of the tool, which
/// is that of the selected handle, then a handle that is only just missed.
[[nodiscard]] Touched touchedAt(glm::dvec2 pixel, const HandleSelection &selection,
                                const std::vector<Grip> &grips, const std::optional<Gizmo> &tool,
                                const View &view);

} // namespace halfspace
