#include "app/step/step_question.h"

#include "widgets/working/working_practice.h"

namespace halfspace {

StepQuestion::StepQuestion(SessionModel &model, LearnerProgress &progress, const WorkingPractice &practice)
    : m_model(model), m_progress(progress), m_practice(practice) {
  model.setQuestionOf([this] { return isOpen() ? Question::Open : Question::Answered; });
}

bool StepQuestion::isOpen() const { return predictionOf(m_model.step()) && !m_progress.ofStep().chosen; }

bool StepQuestion::hidesNumbers() const { return isOpen() || m_practice.hasBlanks(); }

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
