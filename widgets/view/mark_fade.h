// New marks of a step fade in.
#pragma once

#include "lessons/figure/figure.h"
#include "lessons/scene/session.h"
#include "widgets/picture/shapes/arrival.h"

#include <QVariantAnimation>

namespace halfspace {

/// Follows what is shown. Another step of the same lesson makes the marks that it adds arrive over a moment;
/// whatever else changes ends that at once.
class MarkFade : public QObject {
  Q_OBJECT

public:
  /// How long a mark takes to arrive, in milliseconds.
  static constexpr int fadeTime = 250;

  explicit MarkFade(QObject *parent = nullptr);

  /// What is shown from now on; without `moving` all of it is there at once.
  void show(const Session &session, const Figure &figure, bool moving);
  /// Everything is there.
  void finish();
  [[nodiscard]] const Arrival &arrival() const { return m_arrival; }

signals:
  void changed(); ///< of the arrival, while a fade goes on

private:
  std::string m_lesson;
  int m_step = 0;
  Figure m_shown;
  Arrival m_arrival;
  QVariantAnimation m_animation;
};

} // namespace halfspace
