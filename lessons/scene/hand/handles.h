// The handles of a scene.
#pragma once

#include "lessons/object/handle.h"
#include "lessons/scene/placed_scene.h"

namespace halfspace {

/// The handles of all objects that are neither locked nor hidden: one for each bound one that has a place; of
/// the free ones one for each position and each direction, and those that the kinds have of their own.
[[nodiscard]] std::vector<Handle> handlesOf(const PlacedScene &scene);

/// Puts the handles of wholes beside the middles of their corners as they were before: while a hand moves a
/// corner towards one from above or below, it would have to jump over that corner to keep off it.
void keepStill(std::vector<Handle> &handles, const std::vector<Handle> &before);

} // namespace halfspace
