// Where a point lies in a face or in a body.
#pragma once

namespace halfspace {

/// Of a point in the plane of a triangle or a polygon.
enum class FaceLocation { Interior, Edge, Vertex, Outside };
struct FacePlace {
  FaceLocation location = FaceLocation::Outside;
  int feature = -1; ///< the corner's index, or that of the edge; set only for Vertex and Edge
};

/// On: on the body's surface.
enum class SolidPlace { Outside, On, Inside };

} // namespace halfspace
