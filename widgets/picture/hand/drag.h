// Dragging, as plain maths: where a grabbed place goes when the pointer moves.
#pragma once

#include "widgets/picture/camera.h"

namespace halfspace {

/// How a grabbed place may move: along a line, in a plane or on a sphere.
struct DragConstraint {
  enum class Kind { Line, Plane, Sphere };
  Kind kind = Kind::Line;
  Place direction{}; ///< of the line, or the plane's normal; not zero, need not be unit
  Place center{};    ///< of the sphere that the grabbed place lies on
  bool operator==(const DragConstraint &) const = default;
};

[[nodiscard]] inline DragConstraint alongLine(Place direction) {
  return {DragConstraint::Kind::Line, direction, {}};
}
[[nodiscard]] inline DragConstraint inPlane(Place normal) {
  return {DragConstraint::Kind::Plane, normal, {}};
}
[[nodiscard]] inline DragConstraint onSphere(Place center) {
  return {DragConstraint::Kind::Sphere, {}, center};
}

/// Nearer than this (15°) to the eye's direction a line cannot be grabbed: there a pixel would throw an
/// object across the room.
inline constexpr double leastGrabAngle = 0.2617993877991494;
/// A plane cannot be grabbed when it is seen this edge-on (9°). Less than for lines: high points of a scene
/// are always seen flat, and shall still move in x and y.
inline constexpr double leastPlaneGrabAngle = 0.15707963267948966;
/// While a drag goes on the sight may come this near (4°) to the line's direction or the plane: a place just
/// short of the horizon can still be reached, the horizon cannot.
inline constexpr double leastSightAngle = 0.0698131700797732;

/// Whether a drag under this constraint may start at a place. Never for a zero direction.
[[nodiscard]] bool isGrabbable(const DragConstraint &constraint, const Camera &camera, Place at);

/// The place under a pixel on what a constraint lets the place `at` move on: the nearest of a line, and of a
/// sphere on the side, near or far, where `at` is, beside it on its outline. Nothing where the sight misses
/// it or is nearer to it than `leastSightAngle`.
[[nodiscard]] std::optional<Place> placeUnder(glm::dvec2 pixel, const DragConstraint &constraint,
                                              const Camera &camera, PixelSize size, Place at);

/// Where the place `start`, grabbed at the pixel `pressed`, is when the pointer is at `now`: the offset
/// between the pointer and the place is kept. Nothing where the constraint is not grabbable or the sight
/// misses what it moves on. On a sphere the place stays on the side, near or far, where it was grabbed, and
/// beside the sphere it stays on its outline.
[[nodiscard]] std::optional<Place> dragged(const DragConstraint &constraint, const Camera &camera,
                                           PixelSize size, Place start, glm::dvec2 pressed, glm::dvec2 now);

} // namespace halfspace
