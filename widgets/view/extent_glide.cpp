#include "widgets/view/extent_glide.h"

namespace halfspace {

ExtentGlide::ExtentGlide(QObject *parent) : QObject(parent) {
  m_animation.setStartValue(0.0);
  m_animation.setEndValue(1.0);
  m_animation.setDuration(glideTime);
  m_animation.setEasingCurve(QEasingCurve::InOutCubic);
  connect(&m_animation, &QVariantAnimation::valueChanged, this, [this](const QVariant &value) {
    m_part = value.toDouble();
    emit changed();
  });
  connect(&m_animation, &QVariantAnimation::finished, this, [this] {
    m_held.clear();
    emit changed();
  });
}

void ExtentGlide::hold(Extents extents) {
  m_animation.stop();
  m_held = std::move(extents);
  m_part = 0;
  m_isHolding = true;
}

void ExtentGlide::release(bool moving) {
  if (!m_isHolding)
    return;
  m_isHolding = false;
  m_animation.start();
  if (!moving)
    arrive();
}

void ExtentGlide::arrive() {
  if (m_animation.state() == QAbstractAnimation::Running)
    m_animation.setCurrentTime(m_animation.duration());
}

Figure ExtentGlide::drawn(Figure figure) const {
  if (m_held.empty())
    return figure;
  const Extents extents = m_isHolding ? m_held : between(m_held, extentsOf(figure), m_part);
  return heldAt(std::move(figure), extents);
}

} // namespace halfspace
