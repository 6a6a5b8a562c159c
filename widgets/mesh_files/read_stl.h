// STL files, binary ones and texts.
#pragma once

#include "lessons/result.h"
#include "widgets/mesh_files/raw_mesh.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace halfspace {

/// A binary file: 80 bytes of anything, the count, and as many triangles of 50 bytes.
inline constexpr std::size_t stlCountAt = 80;
inline constexpr std::size_t stlBegin = stlCountAt + sizeof(std::uint32_t);
inline constexpr std::size_t stlTriangle = 50;

/// The number in four bytes of a binary file, whatever this machine's order of bytes.
[[nodiscard]] std::uint32_t stlNumber(const char *bytes);

// What checkMeshFile has told to be of the format; the mesh has three corners of its own for each triangle.

/// Reads as many triangles as the file has room for: some programs write a count that is too small.
[[nodiscard]] Result<RawMesh> readBinaryStl(const std::filesystem::path &file, const PartDone &partDone);
[[nodiscard]] Result<RawMesh> readTextStl(const std::filesystem::path &file, const PartDone &partDone);

} // namespace halfspace
