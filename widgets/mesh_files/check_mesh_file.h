// What a mesh file is, and whether it can be what it says: looked at before a reader is let near it.
#pragma once

#include "lessons/result.h"

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace halfspace {

enum class MeshFormat { BinaryStl, TextStl, Obj, Ply };

/// Larger files are refused: 1 MiB less than what fits 31 bits.
inline constexpr std::uint64_t mostMeshFileBytes = (1ULL << 31U) - (1ULL << 20U);
/// What is looked at of a file's beginning.
inline constexpr std::size_t meshFileHead = 1U << 16U;

/// Tells the format by the content, and by the ending of the name (`.stl`, in small or capital letters) where
/// the content leaves it open. Refused, with a sentence: what is no regular file, empty files, too large
/// ones, those of no such format, and those that must be cut off or have too many triangles, as far as counts
/// at their beginning tell.
[[nodiscard]] Result<MeshFormat> checkMeshFile(const std::filesystem::path &file);

/// The same for a file that begins so and has so many bytes. `ending` is with its dot.
[[nodiscard]] Result<MeshFormat> checkMeshHead(std::string_view head, std::uint64_t bytes,
                                               std::string_view ending);

/// The sentences for a file with too many triangles, for one without any, and for one that cannot be read to
/// its end.
[[nodiscard]] std::string sentenceForTooManyTriangles();
[[nodiscard]] std::string sentenceForNoTriangles();
[[nodiscard]] std::string sentenceForDamage();

} // namespace halfspace
