#include "widgets/view/mark_fade.h"

#include <algorithm>
#include <iterator>

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
  std::set<std::string> shown;
  for (const Mark &mark : figure.marks)
    shown.insert(baseOf(mark).id);
  const bool otherStep = session.lesson == m_lesson && session.step != m_step;
  std::set<std::string> added;
  std::set_difference(shown.begin(), shown.end(), m_shown.begin(), m_shown.end(),
                      std::inserter(added, added.end()));
  finish();
  m_lesson = session.lesson;
  m_step = session.step;
  m_shown = std::move(shown);
  if (!otherStep || !moving || added.empty())
    return;
  m_arrival = {std::move(added), 0};
  m_animation.start();
}

void MarkFade::finish() {
  m_animation.stop();
  m_arrival = {};
}

} // namespace halfspace
