#include "widgets/view/picture_hold.h"

#include <utility>

namespace halfspace {

void PictureHold::begin() {
  m_pivot = m_viewpoint.middle();
  m_isNew = true;
}

void PictureHold::turn(double azimuthChange, double elevationChange) {
  Camera camera = m_viewpoint.camera();
  camera.turnAbout(m_pivot, azimuthChange, elevationChange);
  moveTo(camera);
}

void PictureHold::pan(glm::dvec2 pixels) {
  Camera camera = m_viewpoint.camera();
  camera.pan(pixels, m_viewpoint.view().size);
  moveTo(camera);
}

void PictureHold::moveTo(const Camera &camera) {
  if (std::exchange(m_isNew, false))
    m_viewpoint.previous().remember(m_viewpoint.camera());
  m_viewpoint.moveTo(camera);
}

void PictureHold::zoom(double factor, glm::dvec2 pixel) {
  m_viewpoint.stop();
  m_viewpoint.previous().rememberZoomed(m_viewpoint.camera());
  Camera camera = m_viewpoint.camera();
  camera.zoom(factor, pixel, m_viewpoint.view().size);
  m_viewpoint.moveTo(camera);
}

} // namespace halfspace
