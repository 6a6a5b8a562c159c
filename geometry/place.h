// Where a point lies in a face or in a body.
#pragma once

#include <string_view>

namespace halfspace {

/// Of a point in the plane of a triangle or a polygon.
enum class FaceLocation { Interior, Edge, Vertex, Outside };
struct FacePlace {
  FaceLocation location = FaceLocation::Outside;
  int feature = -1; ///< the corner's index, or that of the edge; set only for Vertex and Edge
};

/// On: on the body's surface.
enum class SolidPlace { Outside, On, Inside };

/// For programs: interior, edge, vertex, outside.
[[nodiscard]] constexpr std::string_view nameOf(FaceLocation location) {
  switch (location) {
  case FaceLocation::Interior:
    return "interior";
  case FaceLocation::Edge:
    return "edge";
  case FaceLocation::Vertex:
    return "vertex";
  case FaceLocation::Outside:
    break;
  }
  return "outside";
}

} // namespace halfspace
