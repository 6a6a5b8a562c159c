// Meshes with more triangles than files of ours have.
#pragma once

#include "lessons/scene/scene.h"

#include <string>
#include <vector>

namespace halfspace {

/// Whether a mesh has more triangles than are written (`mostWrittenTriangles`).
[[nodiscard]] bool isTooLargeToWrite(const Object &object);

/// The names of the meshes of a scene that are too large to be written.
[[nodiscard]] std::vector<std::string> largeMeshes(const Scene &scene);

/// The scene as it can be written: without the large meshes, and without what looks at nothing else. A
/// construction that looks at others as well goes on with those.
[[nodiscard]] Scene withoutLargeMeshes(Scene scene);

} // namespace halfspace
