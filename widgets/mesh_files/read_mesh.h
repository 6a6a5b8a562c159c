// Meshes out of files.
#pragma once

#include "lessons/reading/problem.h"
#include "widgets/mesh_files/raw_mesh.h"

#include <filesystem>

namespace halfspace {

/// Reads an STL, OBJ or PLY file. Faces of more than three corners are cut into triangles.
/// OBJ and PLY files are read by VTK, whose readers trust them: one that means harm may end the program, or
/// keep it busy for long. This is for a process of its own (`serveMesh`), or for files that are known.
[[nodiscard]] Result<RawMesh> readMesh(const std::filesystem::path &file, const PartDone &partDone);

} // namespace halfspace
