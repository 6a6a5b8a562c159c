// Where the parts of the gizmo are: shared by what is drawn and what is hit.
#pragma once

#include "widgets/picture/hand/drag.h"
#include "widgets/picture/scene_content.h"

namespace halfspace {

// All in design pixels.
inline constexpr double gizmoArrowStart = 15;
inline constexpr double gizmoArrowEnd = 70;
inline constexpr double gizmoSquareNear = 22;
inline constexpr double gizmoSquareFar = 38;
inline constexpr double gizmoPickDistance = 7;

/// A part of the gizmo in the scene: an arrow from its start to its tip, or a square by its corners.
struct GizmoPartShape {
  Gizmo::Part part = Gizmo::Part::AxisX;
  std::vector<Place> outline; ///< two places for an arrow, four for a square
  [[nodiscard]] bool isSquare() const { return outline.size() == 4; }
};

/// How dragging a part moves the handle.
[[nodiscard]] DragConstraint constraintOf(Gizmo::Part part);

/// The parts that are shown: none without `axes`, and none that could not be grabbed from where the camera
/// stands.
[[nodiscard]] std::vector<GizmoPartShape> gizmoParts(const Gizmo &gizmo, const Camera &camera, PixelSize size,
                                                     double pixelRatio);

/// The part under a pixel; squares come before arrows, which cross them on the screen.
[[nodiscard]] std::optional<Gizmo::Part> gizmoPartAt(const Gizmo &gizmo, const Camera &camera, PixelSize size,
                                                     double pixelRatio, glm::dvec2 pixel);

} // namespace halfspace
