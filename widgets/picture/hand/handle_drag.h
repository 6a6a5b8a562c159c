// One drag of a handle, from press to release: pixels in, exact objects out. Free of Qt and of VTK.
#pragma once

#include "lessons/scene/hand/snap_targets.h"
#include "widgets/picture/hand/drag.h"
#include "widgets/picture/scene_content.h"
#include "widgets/picture/view.h"

namespace halfspace {

/// The freedom that a drag has.
enum class DragMode {
  Horizontal,
  Vertical,
  AxisX,
  AxisY,
  AxisZ,
  PlaneYZ,
  PlaneZX,
  OwnAxis,
  OwnPlane,
  OwnSphere
};

/// Whether the handle says by itself how it moves.
[[nodiscard]] bool isOwn(DragMode mode);

/// The mode that a handle is grabbed in: its own if it has one, else horizontal or vertical as wished,
/// or the other of the two where the camera makes the wished one ungrabbable. Nothing when it cannot be
/// grabbed from here at all.
[[nodiscard]] std::optional<DragMode> grabMode(const Handle &handle, bool vertical, const Camera &camera);

/// Whether it moves every way, so that the gizmo's parts are of use.
[[nodiscard]] bool movesFreely(const Handle &handle);

/// The mode of a part of the gizmo.
[[nodiscard]] DragMode modeOf(Gizmo::Part part);

/// Where a handle is drawn and grabbed: beside the plane's point for its offset knob, else where it is.
[[nodiscard]] Place shownPlace(const Handle &handle);

/// The knob of a handle that no mark of a figure shows; nothing for the others.
[[nodiscard]] std::optional<Knob> knobOf(const Handle &handle, bool hot);

/// Objects are dragged within this box around the origin of the stage, in its units; one that lies outside,
/// as far out as it is.
inline constexpr double dragBox = 30;
/// Special places catch within this many design pixels.
inline constexpr double catchDistance = 9;

/// What a move of the pointer came to.
struct DragMove {
  Object object;      ///< with its new coordinates
  std::string caught; ///< the special case that it snapped to, in plain words; empty for the grid
};

class HandleDrag {
public:
  /// `scene` is the scene at the press: what the drag starts from. What its objects offer catches, and
  /// `asked` for besides.
  HandleDrag(PlacedScene scene, Handle handle, DragMode mode, glm::dvec2 pressed,
             std::vector<SnapTarget> asked = {});

  [[nodiscard]] const Handle &handle() const { return m_handle; }
  [[nodiscard]] DragMode mode() const { return m_mode; }

  /// Goes on in another mode from where the handle is now.
  void setMode(DragMode mode);

  /// The object with the pointer at a pixel; nothing where the pointer's line of sight misses what the handle
  /// moves on.
  [[nodiscard]] std::optional<DragMove> moveTo(glm::dvec2 pixel, const Rational &step, const View &screen);

private:
  PlacedScene m_scene;
  Handle m_handle;
  std::vector<SnapTarget> m_targets;
  DragMode m_mode;
  Handle m_anchor;      ///< the handle as it was where the current mode began
  glm::dvec2 m_pressed; ///< the pixel where it began
  ExactVec3 m_at;       ///< where the handle is now
  glm::dvec2 m_pixel;   ///< the newest pixel
};

} // namespace halfspace
