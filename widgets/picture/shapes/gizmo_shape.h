// Where the parts of the gizmo and of knobs are: shared by what is drawn and what is hit.
#pragma once

#include "widgets/picture/hand/drag.h"
#include "widgets/picture/scene_content.h"

namespace halfspace {

// All in design pixels. The ring around a handle that moves freely is where its own target ends and the
// gizmo's parts begin.
inline constexpr double modeRingRadius = 21;
inline constexpr double gizmoArrowStart = 27;
inline constexpr double gizmoArrowLength = 48;
inline constexpr double gizmoSquareNear = 27;
inline constexpr double gizmoSquareSide = 17;
inline constexpr double gizmoPickDistance = 5;
/// Parts keep so far away from what is seen of handles …
inline constexpr double gizmoGap = 6;
/// … and move up to so much farther out for it, in such steps; then they are hidden.
inline constexpr double gizmoFarthestMove = 32;
inline constexpr double gizmoMoveStep = 8;

inline constexpr double knobBall = 5.5;
inline constexpr double knobReach = 24;
inline constexpr double knobRadius = 2.0;
/// A knob that is selected or hovered is so much larger.
inline constexpr double hotWidth = 1.5;

/// A part of the gizmo in the scene: an arrow from its start to its tip, or a square by its corners.
struct GizmoPartShape {
  Gizmo::Part part = Gizmo::Part::AxisX;
  std::vector<Place> outline; ///< two places for an arrow, four for a square
  [[nodiscard]] bool isSquare() const { return outline.size() == 4; }
};

/// How dragging a part moves the handle.
[[nodiscard]] DragConstraint constraintOf(Gizmo::Part part);

/// The parts that are shown: none without `axes`, none that could not be grabbed from where the camera
/// stands, and none that finds no room beside what the gizmo keeps clear of.
[[nodiscard]] std::vector<GizmoPartShape> gizmoParts(const Gizmo &gizmo, const Camera &camera, PixelSize size,
                                                     double pixelRatio);

/// The part under a pixel; squares come before arrows, which cross them on the screen.
[[nodiscard]] std::optional<Gizmo::Part> gizmoPartAt(const Gizmo &gizmo, const Camera &camera, PixelSize size,
                                                     double pixelRatio, glm::dvec2 pixel);

/// The unit directions in which a knob has an arrow both ways.
[[nodiscard]] std::vector<Place> knobDirections(const Knob &knob, const Camera &camera);

} // namespace halfspace
