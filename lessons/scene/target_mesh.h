// Meshes that a learner adds to a scene as something to aim at.
#pragma once

#include "lessons/object/mesh_shape.h"
#include "lessons/scene/edit.h"

#include <optional>
#include <string>
#include <vector>

namespace halfspace {

/// The edits that put a mesh into a scene of its own names, scaled to the size of a barn, for nobody to look
/// at yet: in the middle, as what somebody begins with. Requires a shape that is a point, or whose longest
/// side is a tame double.
[[nodiscard]] std::vector<Edit> editsForMesh(const Scene &scene, std::shared_ptr<const MeshShape> shape);

/// What a learner's own mesh is called in the scene.
inline constexpr const char *targetName = "target";

/// Whether a scene has constructions that look at meshes.
[[nodiscard]] bool takesMeshes(const Scene &scene);

/// The edits, one after the other, that put a mesh into a scene: scaled to the size of a barn, seen by all
/// constructions that look at meshes and have room for one more. One that was put there before gives way, and
/// the new one stands where it stood. Requires a shape that is a point, or whose longest side is a tame
/// double.
[[nodiscard]] std::vector<Edit> editsForTarget(const Scene &scene, std::shared_ptr<const MeshShape> shape);

/// The edits that put another mesh like one of the scene beside it, with the same shape, and the name that it
/// gets: wallB. Nothing where no construction that looks at the mesh has room for one more.
struct MeshCopy {
  std::string name;
  std::vector<Edit> edits;
};
[[nodiscard]] std::optional<MeshCopy> copyOfMesh(const Scene &scene, const std::string &name);

/// The edits that take a mesh out of all lists, and then out of the scene. One is refused where something
/// looks at nothing else, or looks at it in another way.
[[nodiscard]] std::vector<Edit> editsToRemoveMesh(const Scene &scene, const std::string &name);

} // namespace halfspace
