// A question that is answered before the numbers are shown.
#pragma once

#include "lessons/lesson/lesson.h"
#include "widgets/text/rich_label.h"
#include "widgets/verdict.h"

#include <QAbstractButton>

class QToolButton;

namespace halfspace {

/// One answer: a button with words, and its verdict once there is one.
class ChoiceButton : public QAbstractButton {
  Q_OBJECT
public:
  ChoiceButton(const Typesetter &typesetter, const MarkdownText &words, QWidget *parent = nullptr);

  /// `isOfNow`: it is about the scene as it is; else it is shown in grey.
  void setVerdict(Verdict verdict, bool isOfNow = true);
  [[nodiscard]] Verdict verdict() const { return m_verdict; }
  void setTheme(const Theme &theme);

protected:
  bool event(QEvent *event) override;
  void paintEvent(QPaintEvent *event) override;

private:
  [[nodiscard]] Color edge() const;
  void showInk();

  RichLabel *m_label;
  Verdict m_verdict = Verdict::Open;
  bool m_isOfNow = true;
  Theme m_theme;
};

struct GivenAnswer {
  std::string chosen;  ///< the word of the choice
  std::string right;   ///< that of the right one; empty where none was right
  bool isOfNow = true; ///< what was right then is so still: the scene has not become another case
};

/// The question and its choices; after the answer the right one, the verdict and the reason. What is about
/// the scene before it became another case is grey, and the question can be answered again.
class PredictionBox : public QWidget {
  Q_OBJECT
public:
  PredictionBox(const Typesetter &typesetter, const Prediction &prediction, QWidget *parent = nullptr);

  /// Nothing: the question is open.
  void setAnswer(const std::optional<GivenAnswer> &answer);
  void setTheme(const Theme &theme);
  [[nodiscard]] QList<ChoiceButton *> choices() const { return m_buttons; }
  /// Why an answer is right or not; hidden while the question is open.
  [[nodiscard]] RichLabel *reason() const { return m_reason; }

signals:
  void chosen(const QString &word);
  void reopened(); ///< the learner wants to try again

private:
  void showReason(const GivenAnswer &answer);
  void showInk();

  Prediction m_prediction;
  RichLabel *m_question;
  QList<ChoiceButton *> m_buttons;
  RichLabel *m_reason;
  QToolButton *m_again;
  Theme m_theme;
  bool m_isOfNow = true; ///< the answer
};

} // namespace halfspace
