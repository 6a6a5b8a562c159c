// The page of a step: words, worked lines, question and tasks in the order of the lesson.
#pragma once

#include "lessons/lesson/lesson.h"
#include "widgets/lesson/flight_blocks.h"
#include "widgets/lesson/prediction_box.h"
#include "widgets/lesson/step_dots.h"
#include "widgets/lesson/task_row.h"

#include <algorithm>
#include <array>

class QBoxLayout;
class QLabel;
class QLayout;
class QPushButton;
class QScrollArea;
class QSpacerItem;

namespace halfspace {

class NoteFold;
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

  /// Shows a step of a lesson.
  void setLesson(const Lesson &lesson, int step = 0);
  /// Shows another step; a number out of range shows the nearest one. Its words come by `showWords`.
  void setStep(int step);
  /// What the way on leads to behind the last step; empty: nowhere.
  void setNextLesson(const QString &title);
  /// Sets the step's words with what their live values are now. Keeps the place that was scrolled to.
  void showWords(const LiveValueOf &valueOf);
  /// The blocks about a flight, of the step that is shown.
  [[nodiscard]] FlightBlocks &flight() { return m_flight; }
  /// Of the step's tasks in their order; of those behind them nothing is known. The task that is due once
  /// another is done comes into view.
  void setTaskStates(const std::vector<TaskState> &states);
  /// To the step's question, if it has one; nothing: it is open.
  void setAnswer(const std::optional<GivenAnswer> &answer);
  /// While the page is held nothing on it becomes less high: what is dragged in the scene moves nothing here.
  void setHeld(bool held);
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
  void makeHead(QBoxLayout &layout, WorkingPractice &practice);
  void makeFoot(QBoxLayout &layout);
  /// Puts the step's blocks on the page, instead of those that were there.
  void makeBlocks();
  [[nodiscard]] QWidget *blockOf(const StepWords &words);
  [[nodiscard]] QWidget *blockOf(const StepLines &lines);
  [[nodiscard]] QWidget *blockOf(const StepNote &note);
  [[nodiscard]] QWidget *blockOf(const Task &task);
  [[nodiscard]] QWidget *blockOf(const Prediction &prediction);
  template <class Block> [[nodiscard]] QWidget *blockOf(const Block &ofFlight) {
    return m_flight.addBlock(ofFlight);
  }
  /// A label is to show these words.
  void add(const StepWords &words, RichLabel &label);
  void showStep();
  [[nodiscard]] int scaled(int pixels) const;
  void setGaps();
  /// So that no line of words gets too long.
  void setMargins();
  void showNextButton();
  void keepButtonsWhole();
  void goOn();
  void scrollTo(const QWidget &part);
  [[nodiscard]] int stepCount() const { return static_cast<int>(m_lesson.steps.size()); }
  [[nodiscard]] int lastStep() const { return std::max(0, stepCount() - 1); }

  /// Words as they were read, with the label that they are set in.
  struct SetWords {
    Markdown words;
    RichLabel *label;
  };

  Typesetter m_typesetter; ///< with the lesson's macros
  FlightBlocks m_flight{m_typesetter};
  Theme m_theme;
  Lesson m_lesson;
  int m_step = 0;
  QString m_nextLesson;
  WorkingPractice &m_practice;
  QLabel *m_stepNumber = nullptr;
  QLabel *m_stepTitle = nullptr;
  QScrollArea *m_scroll = nullptr;
  QBoxLayout *m_page = nullptr;
  QBoxLayout *m_head = nullptr;
  QLayout *m_above = nullptr; ///< the title
  QLayout *m_foot = nullptr;
  std::array<QSpacerItem *, 2> m_footSides{};
  QWidget *m_blocks = nullptr;
  // Of the step that is shown:
  LessonPictures m_pictures;
  std::vector<SetWords> m_words;
  std::vector<NoteFold *> m_notes;
  struct SetTask {
    Markdown instruction;
    Markdown now;
    Markdown answer;
    TaskRow *row;
  };
  std::vector<SetTask> m_tasks;
  const TaskRow *m_dueTask = nullptr;    ///< null while none is known, or all are done
  PredictionBox *m_prediction = nullptr; ///< null in steps without one
  StepDots *m_dots = nullptr;
  QPushButton *m_back = nullptr;
  QPushButton *m_next = nullptr;
};

} // namespace halfspace
