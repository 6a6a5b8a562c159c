#include "app/work/learner_progress.h"

#include "app/work/progress_file.h"

namespace halfspace {

LearnerProgress::LearnerProgress(SessionModel &model, PutAsideFiles &putAside)
    : m_model(model), m_putAside(putAside), m_progress(stored()), m_kept(m_progress) {
  model.setQuestionOf([this] { return hasOpenQuestion() ? Question::Open : Question::Answered; });
}

LessonProgress LearnerProgress::stored() {
  const auto found = readProgress(progressFile());
  if (found)
    return withStepNames(*found, m_model.library().lessons);
  m_putAside.add(found.problem()); // where it cannot be, it is not written either
  return {};
}

StepProgress &LearnerProgress::ofStep() {
  return m_progress[{m_model.session().lesson, nameOfStep(m_model.lesson(), m_model.session().step)}];
}

bool LearnerProgress::hasOpenQuestion() { return predictionOf(m_model.step()) && !ofStep().chosen; }

LessonState LearnerProgress::stateOf(const Lesson &lesson) const {
  return halfspace::stateOf(lesson, m_progress);
}

QStringList LearnerProgress::idsStillNeeded(const Lesson &lesson) const {
  QStringList ids;
  if (stateOf(lesson) == LessonState::Done)
    return ids;
  for (const Need &need : lesson.needs)
    if (const Lesson *needed = m_model.library().find(need.id);
        needed && stateOf(*needed) != LessonState::Done)
      ids << QString::fromStdString(needed->id);
  return ids;
}

void LearnerProgress::nameSteps(const std::vector<Lesson> &lessons) {
  m_progress = withStepNames(m_progress, lessons);
}

std::optional<Problem> LearnerProgress::keep() {
  if (m_progress == m_kept)
    return {};
  if (const auto found = readProgress(progressFile()); !found)
    if (auto problem = m_putAside.add(found.problem()))
      return problem;
  if (auto problem = addProgress(m_progress, progressFile()))
    return problem;
  m_kept = m_progress;
  return {};
}

} // namespace halfspace
