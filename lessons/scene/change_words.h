// What is done to an object, in plain words, as the history says it: “Move the tip of r”.
#pragma once

#include "lessons/object/handle.h"
#include "lessons/scene/edit.h"

namespace halfspace {

/// What dragging a handle of the scene does: “Move Q”, “Move P₀ of E”, “Move the tip of r”, “Slide E along
/// its normal”, “Move T as a whole”. Empty where the scene has no such object.
[[nodiscard]] std::string wordsForMoving(const Scene &scene, const Handle &handle);
/// What giving a coordinate of the scene another number does, in the same words: “Move the tip of r”; a
/// number that is no place is changed: “Change R of S”.
[[nodiscard]] std::string wordsForChanging(const Scene &scene, const CoordinateId &id);
/// What is done to a label: “Move a label”, “Hide a label”, “Put a label back”.
[[nodiscard]] std::string wordsForLabel(const Scene &scene, const ChangeLabel &change);

} // namespace halfspace
