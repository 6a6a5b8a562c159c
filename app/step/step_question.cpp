#include "app/step/step_question.h"

namespace halfspace {

void StepQuestion::answer(const QString &choice) {
  // Judged now: the learner may drag on afterwards.
  StepProgress &done = m_progress.ofStep();
  done.chosen = choice.toStdString();
  done.right = rightChoice(*predictionOf(m_model.step()), m_model.evaluation());
  emit changed();
  m_model.takeQuestion();
}

void StepQuestion::reopen() {
  forgetAnswer();
  m_model.takeQuestion();
}

void StepQuestion::forgetAnswer() {
  if (!predictionOf(m_model.step()))
    return;
  m_progress.ofStep().chosen.reset();
  emit changed();
}

} // namespace halfspace
