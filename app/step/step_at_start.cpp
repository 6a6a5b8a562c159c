#include "app/step/step_at_start.h"

namespace halfspace {

StepAtStart::StepAtStart(const SessionModel &model) : m_model(model) {
  connect(&model, &SessionModel::lessonChanged, this, [this] { m_evaluation.reset(); });
  connect(&model, &SessionModel::stepChanged, this, [this] { m_lines.reset(); });
}

const LinesOfStep &StepAtStart::lines() {
  if (!m_evaluation)
    m_evaluation = evaluate(m_model.lesson().scene);
  if (!m_lines)
    m_lines = linesOfStep(m_model.step(), *m_evaluation);
  return *m_lines;
}

bool StepAtStart::lacksLines() {
  // Unchanged, nothing is evaluated for it: neither when the window opens nor when a step is turned to.
  return isChanged(m_model) && m_model.shown().working.lines.size() < lines().working.lines.size();
}

bool StepAtStart::lacksLinesIn(const Scene &scene) {
  return linesOfStep(m_model.step(), evaluate(scene)).working.lines.size() < lines().working.lines.size();
}

} // namespace halfspace
