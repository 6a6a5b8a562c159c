// The way from step to step of a lesson.
#pragma once

#include "widgets/session_model.h"

#include <QObject>

namespace halfspace {

class StepAtStart;

/// Turns to steps. One whose lines the present scene does not have, because a task has made a special case,
/// begins with the scene that the learner came to the last step with, or else with the lesson's own: nobody
/// has to take back by hand what a task has asked for. That can be undone.
class StepTurner : public QObject {
  Q_OBJECT
public:
  /// Both must outlive it.
  StepTurner(SessionModel &model, StepAtStart &atStart);

  /// One out of range leads to the nearest.
  void turnTo(int step);
  /// So many steps on, or back.
  void turnBy(int steps) { turnTo(m_model.session().step + steps); }

private:
  void arrive() { m_arrivedWith = m_model.session().scene; }
  [[nodiscard]] const Scene &sceneWithLines() const;

  SessionModel &m_model;
  StepAtStart &m_atStart;
  Scene m_arrivedWith; ///< at the present step
};

} // namespace halfspace
