// What the learner has done in the lessons, kept between starts.
#pragma once

#include "app/work/put_aside.h"
#include "lessons/lesson/lesson_progress.h"
#include "widgets/session_model.h"

namespace halfspace {

/// Begins with what earlier starts have kept. A file that cannot be read is put aside. The model asks here
/// whether the question of its step is answered.
class LearnerProgress {
public:
  /// Both must outlive it; behind its end the model has no other outcome any more.
  LearnerProgress(SessionModel &model, PutAsideFiles &putAside);

  /// Of the step that is shown.
  [[nodiscard]] StepProgress &ofStep();
  /// Whether that step asks a question that is not answered yet.
  [[nodiscard]] bool hasOpenQuestion();
  [[nodiscard]] LessonState stateOf(const Lesson &lesson) const;
  /// The ids of the lessons that this one builds on and that are not done; none where it is done itself.
  [[nodiscard]] QStringList idsStillNeeded(const Lesson &lesson) const;
  /// Steps that older files tell by their numbers get their names from these lessons.
  void nameSteps(const std::vector<Lesson> &lessons);
  /// Keeps what was done since it was last kept; why it cannot be kept.
  std::optional<Problem> keep();

private:
  [[nodiscard]] LessonProgress stored();

  const SessionModel &m_model;
  PutAsideFiles &m_putAside;
  LessonProgress m_progress;
  LessonProgress m_kept; ///< as its file has it
};

} // namespace halfspace
