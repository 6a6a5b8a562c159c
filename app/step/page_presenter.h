// The page of the step that is shown: its words, its lines, its tasks, and the way on.
#pragma once

#include "lessons/lesson/glossary.h"
#include "widgets/session_model.h"

#include <QObject>

namespace halfspace {

class LearnerProgress;
class LessonPage;
class StepAtStart;
class StepQuestion;
class WorkingPractice;

/// Writes the page from the session and from what is done, and takes up what the learner does there.
class PagePresenter : public QObject {
  Q_OBJECT
public:
  /// All must outlive it.
  PagePresenter(SessionModel &model, LessonPage &page, WorkingPractice &practice, StepQuestion &question,
                LearnerProgress &progress, StepAtStart &atStart);

  /// Another lesson; its step is shown next.
  void showLesson();
  /// Another step of the lesson; its words and lines come with its outcome.
  void showStep();
  void showLines();
  /// Words and tasks, as they are with the present numbers; the words without them while they are hidden.
  void showWords(bool numbersHidden);
  /// Behind the last lesson nothing happens.
  void openNextLesson();

private:
  /// Tells which tasks are done, and what became of the answer.
  void judge();
  void followGesture();
  /// The lesson behind the one that is shown; null behind the last.
  [[nodiscard]] const Lesson *nextLesson() const;

  SessionModel &m_model;
  LessonPage &m_page;
  WorkingPractice &m_practice;
  StepQuestion &m_question;
  LearnerProgress &m_progress;
  StepAtStart &m_atStart;
  Glossary m_glossary; ///< of the library that the lesson is from
};

} // namespace halfspace
