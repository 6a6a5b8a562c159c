#include "widgets/view/camera_glide.h"

#include "widgets/picture/camera_views.h"

namespace halfspace {

CameraGlide::CameraGlide() {
  m_animation.setStartValue(0.0);
  m_animation.setEndValue(1.0);
  m_animation.setDuration(glideTime);
  m_animation.setEasingCurve(QEasingCurve::InOutCubic);
  connect(&m_animation, &QVariantAnimation::valueChanged, this,
          [this](const QVariant &value) { emit moved(between(m_from, m_to, value.toDouble())); });
}

void CameraGlide::start(const Camera &from, const Camera &to) {
  m_animation.stop();
  m_from = from;
  m_to = to;
  m_animation.start();
}

void CameraGlide::arrive() {
  if (m_animation.state() == QAbstractAnimation::Running)
    m_animation.setCurrentTime(m_animation.duration());
}

} // namespace halfspace
