#include "widgets/picture/resized_camera.h"

#include <utility>

namespace halfspace {

Camera ResizedCamera::resized(const Camera &camera, PixelSize now) {
  const PixelSize before = std::exchange(m_size, now);
  if (before == now)
    return camera;
  if (!m_newest || !(m_newest->after == camera))
    m_newest = Change{camera, before, camera};
  m_newest->after = keptBetweenSides(m_newest->before, m_newest->size, now);
  return m_newest->after;
}

} // namespace halfspace
