// The answers to a question, while somebody writes them.
#pragma once

#include "lessons/lesson/lesson_draft.h"

#include <QWidget>

#include <map>
#include <utility>

class QLineEdit;

namespace halfspace {

/// What learners read as answers, by the word that makes each the right one.
using AnswerTexts = std::map<std::string, QString>;

/// A field for each word that a value can have, and for all others.
class AnswerFields : public QWidget {
  Q_OBJECT
public:
  /// `now` is the value's word at the start.
  AnswerFields(const std::vector<std::string> &words, const std::string &now, const AnswerTexts &texts);

  /// Without those that have no text.
  [[nodiscard]] std::vector<DraftChoice> choices() const;
  [[nodiscard]] AnswerTexts texts() const;

signals:
  void changed();

private:
  std::vector<std::pair<std::string, QLineEdit *>> m_fields; ///< from top to bottom
};

} // namespace halfspace
