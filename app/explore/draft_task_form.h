// The task of a lesson's step, while somebody writes it.
#pragma once

#include "lessons/lesson/lesson_draft.h"
#include "lessons/scene/evaluation.h"

#include <QGroupBox>

class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace halfspace {

class ValueList;

/// What the learner is to do, and the condition by which the program sees that it is done. Unticked: nothing.
class DraftTaskForm : public QGroupBox {
  Q_OBJECT
public:
  /// Over a scene as it is at the start of the lesson, which must outlive the form.
  explicit DraftTaskForm(const Evaluation &start);

  void fill(const std::optional<DraftTask> &task);
  [[nodiscard]] std::optional<DraftTask> task() const;

signals:
  void changed();

private:
  /// Goes on with the condition by a value that is chosen.
  void insert(const QString &name);
  /// Whether the condition holds at the start.
  void tellNow();

  const Evaluation &m_start;
  QPlainTextEdit *m_instruction;
  QLineEdit *m_condition;
  ValueList *m_values;
  QLabel *m_now;
};

} // namespace halfspace
