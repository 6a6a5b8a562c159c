// The words of a lesson, step by step.
#pragma once

#include "lessons/lesson/lesson.h"
#include "widgets/lesson/prediction_box.h"
#include "widgets/lesson/step_dots.h"

class QBoxLayout;
class QLabel;
class QPushButton;
class QScrollArea;

namespace halfspace {

/// Shows one step: title, words, tasks and question; under them the way back and on. In a wide panel tasks
/// and question stand beside the words. It keeps no state of the lesson: the owner tells what is done and
/// what was answered.
class LessonPanel : public QWidget {
  Q_OBJECT
public:
  /// What it sets has the macros of the lesson that is shown.
  explicit LessonPanel(const Typesetter &typesetter, QWidget *parent = nullptr);
  ~LessonPanel() override;

  /// Shows the first step of a lesson.
  void setLesson(const Lesson &lesson);
  /// Shows another step; a number out of range shows the nearest one. Its words come by `setMarkdown`.
  void setStep(int step);
  /// The step's words with live values filled in. Keeps the place that was scrolled to.
  void setMarkdown(const QString &markdown);
  /// Which of the step's tasks are done, in their order.
  void setTasksDone(const std::vector<bool> &done);
  /// The word of the choice that was made, if one was, and of the right one.
  void setPredictionAnswer(const std::optional<std::string> &chosen, const std::string &right);
  void setTheme(const Theme &theme);

  [[nodiscard]] QSize sizeHint() const override;

signals:
  void stepRequested(int step);
  void predictionChosen(const QString &word);

protected:
  void resizeEvent(QResizeEvent *event) override;

private:
  void makeHead(QBoxLayout &layout);
  void makeFoot(QBoxLayout &layout);
  void makeExercises();
  /// Scrolls to the reason of an answer.
  void showReason();
  [[nodiscard]] const LessonStep *step() const;
  [[nodiscard]] int stepCount() const { return static_cast<int>(m_lesson.steps.size()); }

  Typesetter m_typesetter; ///< with the lesson's macros
  Theme m_theme;
  Lesson m_lesson;
  int m_step = 0;
  QLabel *m_stepTitle = nullptr;
  RichLabel *m_words = nullptr;
  QScrollArea *m_scroll = nullptr;
  QBoxLayout *m_columns = nullptr; ///< words and exercises, beside or below each other
  QWidget *m_exercises = nullptr;
  std::vector<TaskRow *> m_tasks;
  PredictionBox *m_prediction = nullptr; ///< null in steps without one
  StepDots *m_dots = nullptr;
  QPushButton *m_back = nullptr;
  QPushButton *m_next = nullptr;
};

} // namespace halfspace
