// Meshes out of files.
#pragma once

#include "lessons/result.h"
#include "widgets/mesh_files/raw_mesh.h"

#include <filesystem>

namespace halfspace {

/// Reads an STL, OBJ or PLY file. Faces of more than three corners are cut into triangles.
/// Takes time and memory as the file is long, up to `mostMeshFileBytes`; a process of its own (`serveMesh`)
/// bounds both.
[[nodiscard]] Result<RawMesh> readMesh(const std::filesystem::path &file, const PartDone &partDone);

} // namespace halfspace
