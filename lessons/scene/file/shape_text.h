// The shapes of meshes as files have them.
#pragma once

#include "lessons/object/mesh_shape.h"
#include "lessons/result.h"

#include <string>
#include <string_view>

namespace halfspace {

/// What corners and faces are called in files.
inline constexpr const char *cornersField = "corners";
inline constexpr const char *facesField = "faces";
/// A shape has at most so many triangles in a file of ours, once its faces are cut.
inline constexpr std::size_t mostWrittenTriangles = 50000;
/// A face has at most so many corners there.
inline constexpr std::size_t mostFaceCorners = 32;

/// Reads a shape as files have it: corners `0 0 0, 4 0 0, 0 3 0.5`, counted from 0, and faces by the numbers
/// of their corners, `0 1 2, 0 2 3 4`. A coordinate must be a double exactly: 0.5 and 0.375 are, 0.1 is not.
[[nodiscard]] Result<std::shared_ptr<const MeshShape>> readShape(std::string_view corners,
                                                                 std::string_view faces);
/// The same, written. Of triangles without faces each is a face.
struct WrittenShape {
  std::string corners;
  std::string faces;
};
[[nodiscard]] WrittenShape written(const MeshShape &shape);

} // namespace halfspace
