// One step of a lesson, while somebody writes it.
#pragma once

#include "lessons/lesson/lesson_draft.h"
#include "lessons/scene/evaluation.h"

#include <QWidget>

class QLineEdit;
class QPlainTextEdit;
class QTabWidget;

namespace halfspace {

class CheckList;
class DraftQuestionForm;
class DraftTaskForm;

/// The title of a step, and in tabs below it its words, what it shows of the scene, its question, its task.
class DraftStepForm : public QWidget {
  Q_OBJECT
public:
  /// Over a scene as it is at the start of the lesson, which must outlive the form.
  explicit DraftStepForm(const Evaluation &start);

  void fill(const DraftStep &step);
  [[nodiscard]] DraftStep step() const;
  void showWords();

signals:
  void changed();

private:
  [[nodiscard]] QWidget *wordsPage(const Evaluation &start);
  [[nodiscard]] QWidget *shownPage();

  QLineEdit *m_title;
  QPlainTextEdit *m_words;
  CheckList *m_workings;
  CheckList *m_hidden;
  DraftQuestionForm *m_question;
  DraftTaskForm *m_task;
  QTabWidget *m_tabs;
};

} // namespace halfspace
