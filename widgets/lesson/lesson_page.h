// The page of a step: words, worked lines, question and tasks in the order of the lesson.
#pragma once

#include "lessons/lesson/glossary.h"
#include "widgets/lesson/page_foot.h"
#include "widgets/lesson/page_head.h"
#include "widgets/lesson/step_blocks.h"

class QScrollArea;

namespace halfspace {

class WorkingPractice;

/// Shows one step from top to bottom in one place; under it the way back and on. It keeps no state of the
/// lesson: the owner tells what is done and what was answered.
class LessonPage : public QWidget {
  Q_OBJECT
public:
  /// What it sets has the macros of the lesson that is shown. `practice` becomes a part of the page, and
  /// shows the lines.
  LessonPage(const Typesetter &typesetter, WorkingPractice &practice, QWidget *parent = nullptr);
  ~LessonPage() override;

  /// What follows are steps of this lesson, and what they have in common is its. Which of them is shown comes
  /// by `showStep`.
  void setLesson(const Lesson &lesson);
  /// Shows a step, which has this number among those of the lesson, counted from 0, with the glossary that
  /// its words lead to. They come by `showWords`.
  void showStep(const LessonStep &step, int number, const Glossary &glossary);
  /// Scrolls to what stands first.
  void showTop();
  /// What the way on leads to behind the last step; empty: nowhere.
  void setNextLesson(const QString &title) { m_foot->setNextLesson(title); }
  /// Sets the step's words with what their live values are now. These are asked for again where words come
  /// into sight: what `valueOf` looks at must outlive the page. Keeps the place that was scrolled to.
  void showWords(LiveValueOf valueOf) { m_blocks->showWords(std::move(valueOf)); }
  /// The blocks about a flight, of the step that is shown.
  [[nodiscard]] FlightBlocks &flight() { return m_flight; }
  /// Of the step's tasks in their order; of those behind them nothing is known. The task that is due once
  /// another is done comes into view.
  void setTaskStates(const std::vector<TaskState> &states) { m_blocks->setTaskStates(states); }
  /// To the step's question, if it has one; nothing: it is open.
  void setAnswer(const std::optional<GivenAnswer> &answer) { m_blocks->setAnswer(answer); }
  /// While the page is held nothing on it becomes less high: what is dragged in the scene moves nothing here.
  void setHeld(bool held) { m_blocks->setHeld(held); }
  void setTheme(const Theme &theme);
  /// No line of words is longer, in pixels.
  [[nodiscard]] static int longestLine(const QFontMetrics &type);

  [[nodiscard]] QSize sizeHint() const override;

signals:
  void stepRequested(int step);
  void nextLessonRequested();
  void predictionChosen(const QString &word);
  void predictionReopened(); ///< the learner wants to try the question again

protected:
  void resizeEvent(QResizeEvent *event) override;

private:
  void layOut();
  /// Puts the step's blocks on the page, instead of those that were there.
  void makeBlocks(const LessonStep &step, const Glossary &glossary);
  /// So that no line of words gets too long.
  void setMargins();
  void scrollTo(const QWidget &part);
  [[nodiscard]] int scaled(int pixels) const;

  Typesetter m_typesetter; ///< with the lesson's macros
  FlightBlocks m_flight{m_typesetter};
  Theme m_theme;
  std::filesystem::path m_folder; ///< of the lesson, see LessonPictures
  int m_stepCount = 0;            ///< of the lesson
  WorkingPractice &m_practice;
  QScrollArea *m_scroll;
  QVBoxLayout *m_page; ///< what is scrolled
  PageHead *m_head;
  StepBlocks *m_blocks; ///< of the step that is shown
  PageFoot *m_foot;
};

} // namespace halfspace
