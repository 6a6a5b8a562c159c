#include "widgets/view/frame_pacer.h"

#include <utility>

namespace halfspace {

FramePacer::FramePacer() {
  m_timer.setSingleShot(true);
  connect(&m_timer, &QTimer::timeout, this, &FramePacer::due);
}

void FramePacer::request() {
  if (m_awaitsPaint)
    m_isWanted = true;
  else if (!m_timer.isActive())
    m_timer.start(0);
}

void FramePacer::begin() {
  m_timer.stop();
  m_isWanted = false;
}

void FramePacer::painted() {
  m_awaitsPaint = false;
  if (std::exchange(m_isWanted, false))
    request();
}

} // namespace halfspace
