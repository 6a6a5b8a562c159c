// OBJ files.
#pragma once

#include "lessons/result.h"
#include "widgets/mesh_files/raw_mesh.h"

#include <filesystem>

namespace halfspace {

/// Reads the corners and the faces; other lines are passed over. The first broken line is a problem.
[[nodiscard]] Result<RawMesh> readObj(const std::filesystem::path &file, const PartDone &partDone);

} // namespace halfspace
