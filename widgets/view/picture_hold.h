// The picture in the hand.
#pragma once

#include "widgets/view/viewpoint.h"

namespace halfspace {

/// Turns and moves the camera of a view as a hand does, from press to release. What was seen before is one of
/// the views that can be gone back to.
class PictureHold {
public:
  /// The viewpoint must outlive it.
  explicit PictureHold(Viewpoint &viewpoint) : m_viewpoint(viewpoint) {}

  /// Takes hold of the picture, to turn it about the middle of what is in view or to move it.
  void begin();
  /// Turns what is held, by angles in radians.
  void turn(double azimuthChange, double elevationChange);
  /// Moves what is held, as a pointer moved by so many pixels.
  void pan(glm::dvec2 pixels);
  /// Without a hold: comes nearer to what is at a pixel (factor < 1), or goes away from it. One step of many
  /// in a row.
  void zoom(double factor, glm::dvec2 pixel);

private:
  void moveTo(const Camera &camera);

  Viewpoint &m_viewpoint;
  Place m_pivot{};      ///< what the picture is turned about
  bool m_isNew = false; ///< nothing has moved yet
};

} // namespace halfspace
