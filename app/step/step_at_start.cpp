#include "app/step/step_at_start.h"

namespace halfspace {

StepAtStart::StepAtStart(const SessionModel &model) : m_model(model) {
  connect(&model, &SessionModel::stepChanged, this, [this] { m_shown.reset(); });
}

const Shown &StepAtStart::shown() {
  if (!m_shown)
    m_shown = shownIn(m_model.step(), evaluate(m_model.lesson().scene));
  return *m_shown;
}

bool StepAtStart::lacksLines() {
  // Unchanged, nothing is evaluated for it: neither when the window opens nor when a step is turned to.
  return m_model.isChanged() && m_model.shown().working.lines.size() < shown().working.lines.size();
}

} // namespace halfspace
