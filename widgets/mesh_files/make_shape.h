// From a mesh as a file has it to one whose first hit by a ray can be asked.
#pragma once

#include "lessons/object/mesh_shape.h"
#include "lessons/result.h"
#include "widgets/mesh_files/raw_mesh.h"

#include <atomic>
#include <memory>
#include <string>

namespace halfspace {

/// The longest side of a mesh's box, in the file's units: no scale that a scene may have would make others as
/// large as a barn.
inline constexpr double longestMeshSide = 5e8;
inline constexpr double shortestMeshSide = 1e-8;
/// Coordinates are rounded to multiples of the power of two that the longest side does not exceed, divided by
/// 2 to this power.
inline constexpr int meshGridBits = 20;

struct LoadedMesh {
  std::shared_ptr<const MeshShape> shape;
  std::string name;           ///< the file's, without its ending
  std::size_t triangles = 0;  ///< of the shape
  std::size_t degenerate = 0; ///< left out: without an area, as they are in the file or once rounded
  std::size_t repeated = 0;   ///< left out: with the same three corners as an earlier one
  std::size_t broken = 0;     ///< left out: with a corner that is not there, or is no number
  Vec3<double> size{};        ///< of the box around what is not broken, in the file's units
};

/// Moves the corners so that the middle of their box is at 0 in x and y and its lowest z is 0, rounds them to
/// a grid of about a millionth of the longest side (`meshGridBits`), so that fractions stay short, makes one
/// corner of equal ones, leaves triangles out as `LoadedMesh` says, and makes the search for hits. A problem
/// where nothing is left, or where the box is too long or too short.
/// (1) Every corner of the shape is one that `readShape` takes.
/// (2) No two triangles of the shape have the same corners, and each has an area.
/// Takes time and memory about as the number of triangles, wherever they lie. For a thread of its own: once
/// `cancelled`, it ends soon with a problem that is for nobody.
[[nodiscard]] Result<LoadedMesh> makeShape(RawMesh raw, std::string name, const std::atomic<bool> &cancelled,
                                           const PartDone &partDone);

} // namespace halfspace
