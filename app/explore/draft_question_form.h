// The question of a lesson's step, while somebody writes it.
#pragma once

#include "app/explore/answer_fields.h"
#include "lessons/lesson/entry_names.h"
#include "lessons/scene/evaluation.h"

#include <QGroupBox>

class QComboBox;
class QLineEdit;
class QPlainTextEdit;
class QScrollArea;

namespace halfspace {

/// A question with its answers, one for each word that the value which decides can have. Unticked: the step
/// asks nothing.
class DraftQuestionForm : public QGroupBox {
  Q_OBJECT
public:
  /// Over a scene as it is at the start of the lesson, which must outlive the form.
  explicit DraftQuestionForm(const Evaluation &start);

  void fill(const std::optional<DraftQuestion> &question);
  /// Answers without a text are left out.
  [[nodiscard]] std::optional<DraftQuestion> question() const;

signals:
  void changed();

private:
  /// Fields for the words of the value that is chosen; what was written of them before stays.
  void showAnswers();

  const Evaluation &m_start;
  std::vector<OfferedValue> m_values; ///< that are words
  QLineEdit *m_ask;
  QComboBox *m_value;
  QScrollArea *m_room;
  AnswerFields *m_answers = nullptr; ///< those in the room
  AnswerTexts m_texts;               ///< of all that were there
  QPlainTextEdit *m_why;
};

} // namespace halfspace
