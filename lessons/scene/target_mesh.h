// A learner's own mesh as something to aim at.
#pragma once

#include "lessons/object/mesh_shape.h"
#include "lessons/scene/edit.h"

#include <vector>

namespace halfspace {

/// What the mesh is called in the scene.
inline constexpr const char *targetName = "target";

/// Whether a scene has constructions that look at meshes.
[[nodiscard]] bool takesMeshes(const Scene &scene);

/// The edits, one after the other, that put a mesh into a scene: scaled to the size of a barn, seen by all
/// constructions that look at meshes and have room for one more. One that was put there before gives way, and
/// the new one stands where it stood.
[[nodiscard]] std::vector<Edit> editsForTarget(const Scene &scene, std::shared_ptr<const MeshShape> shape);

} // namespace halfspace
