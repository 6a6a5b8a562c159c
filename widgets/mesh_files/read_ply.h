// PLY files: texts, and binary ones with either byte first.
#pragma once

#include "lessons/result.h"
#include "widgets/mesh_files/raw_mesh.h"

#include <filesystem>

namespace halfspace {

/// Reads what checkMeshFile has told to be a PLY file. Elements and properties other than corners and faces
/// are passed over.
[[nodiscard]] Result<RawMesh> readPly(const std::filesystem::path &file, const PartDone &partDone);

} // namespace halfspace
