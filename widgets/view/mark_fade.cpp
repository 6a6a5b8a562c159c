#include "widgets/view/mark_fade.h"

#include "lessons/figure/added_marks.h"

#include <utility>

namespace halfspace {

MarkFade::MarkFade(QObject *parent) : QObject(parent) {
  m_animation.setStartValue(0.0);
  m_animation.setEndValue(1.0);
  m_animation.setDuration(fadeTime);
  connect(&m_animation, &QVariantAnimation::valueChanged, this, [this](const QVariant &value) {
    m_arrival.presence = value.toDouble();
    emit changed();
  });
  connect(&m_animation, &QVariantAnimation::finished, this, [this] {
    m_arrival = {};
    emit changed();
  });
}

void MarkFade::show(const Session &session, const Figure &figure, bool moving) {
  const bool otherStep = session.lesson == m_lesson && session.step != m_step;
  finish();
  m_lesson = session.lesson;
  m_step = session.step;
  const Figure before = std::exchange(m_shown, figure);
  if (!otherStep || !moving)
    return;
  std::set<std::string> added = idsAdded(before, figure);
  if (added.empty())
    return;
  m_arrival = {std::move(added), 0};
  m_animation.start();
}

void MarkFade::finish() {
  m_animation.stop();
  m_arrival = {};
}

} // namespace halfspace
