#include "app/step/step_turner.h"

#include "app/step/step_at_start.h"

namespace halfspace {

StepTurner::StepTurner(SessionModel &model, StepAtStart &atStart)
    : m_model(model), m_atStart(atStart), m_arrivedWith(model.session().scene) {
  connect(&model, &SessionModel::lessonChanged, this, &StepTurner::arrive);
  connect(&model, &SessionModel::sceneReplaced, this, &StepTurner::arrive); // new numbers, or a fresh start
}

void StepTurner::turnTo(int step) {
  m_model.setStep(step);
  if (m_atStart.lacksLines())
    m_model.history().replaceScene(sceneWithLines(), tr("Set the scene back"));
  arrive();
}

const Scene &StepTurner::sceneWithLines() const {
  return m_atStart.lacksLinesIn(m_arrivedWith) ? m_model.lesson().scene : m_arrivedWith;
}

} // namespace halfspace
