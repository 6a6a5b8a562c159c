// Where a point lies in a face or in a body.
#pragma once

namespace halfspace {

/// Of a point in the plane of a triangle or a polygon.
enum class FacePart { Interior, Edge, Vertex, Outside };
struct FaceLocation {
  FacePart part = FacePart::Outside;
  int feature = -1; ///< the corner's index, or that of the edge; set only for Vertex and Edge
};

/// On: on the body's surface.
enum class SolidLocation { Outside, On, Inside };

} // namespace halfspace
