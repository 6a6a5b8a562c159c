// The dialog in which a teacher makes a lesson of a scene.
#pragma once

#include "lessons/lesson/lesson_draft.h"
#include "lessons/scene/evaluation.h"

#include <QDialog>

#include <functional>

class QLabel;
class QLineEdit;
class QPushButton;

namespace halfspace {

class DraftStepForm;
class DraftStepList;

/// What keeps a draft from being saved, the worst first; none: nothing does.
using CheckDraft = std::function<std::vector<DraftProblem>(const LessonDraft &)>;

/// The title and the steps of a lesson, with what is wrong with them said below while it is written. Only
/// what nothing is wrong with can be saved.
class LessonDialog : public QDialog {
  Q_OBJECT
public:
  /// A draft with one step at least, of a scene as it is at the start of the lesson, which must outlive the
  /// dialog. `leftOut` tells what of the scene will not be in the lesson; empty for nothing.
  LessonDialog(LessonDraft draft, const Evaluation &start, const QString &leftOut, CheckDraft check,
               QWidget *parent);

  [[nodiscard]] const LessonDraft &draft() const { return m_draft; }
  /// To be written now; the last one where there are not so many.
  void showStep(int step);
  /// It is the lesson of a file, which is written to without a question.
  void setEditing();
  /// Says why it was not saved, until something is changed.
  void complain(const QString &sentence);

signals:
  void written(); ///< something of the draft
  void saveWanted();
  void discardWanted(); ///< all that is written and not saved

private:
  [[nodiscard]] QWidget *buttons();
  void choose(int step);
  void addStep();
  void removeStep();
  void moveStep(int places);
  void takeStep();
  void takeChange();
  void showSteps();
  void check();

  LessonDraft m_draft;
  int m_step = 0;
  CheckDraft m_check;
  QLineEdit *m_title;
  DraftStepList *m_steps;
  DraftStepForm *m_form;
  QLabel *m_wrong;
  QPushButton *m_save;
};

} // namespace halfspace
