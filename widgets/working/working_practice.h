// How much of the worked lines the learner completes, and what came of it.
#pragma once

#include "lessons/lesson/line_practice.h"
#include "widgets/working/step_working.h"

class QActionGroup;
class QLabel;
class QMenu;
class QToolButton;

namespace halfspace {

/// A row of tools: the choice of how much is blank, new numbers, the score.
class WorkingPractice : public QWidget {
  Q_OBJECT
public:
  /// The typesetter must outlive it.
  explicit WorkingPractice(const Typesetter &typesetter, QWidget *parent = nullptr);

  [[nodiscard]] StepWorking &working() { return m_blocks; }

  /// The lesson and step whose lines come next; `asked` is what the step leaves to the learner if it says so.
  void setStep(const std::string &lesson, int step, std::optional<Fading> asked);
  /// Shows a working, so many lines in each block. `hidden`: no line shows numbers or asks for them, because
  /// a question goes before.
  void setWorking(const Working &working, const std::vector<std::size_t> &linesIn, bool hidden);

  /// Whether there are other numbers to work with.
  void offerNewNumbers(bool offered);

  /// Whether some lines ask to be filled in.
  [[nodiscard]] bool hasBlanks() const { return !m_practice.fade().gaps.empty(); }

signals:
  /// The learner has chosen, completed a line, or had one shown.
  void blanksChanged();
  /// The learner wants to work with other numbers. Whoever has the scene gives it some at once.
  void newNumbersRequested();

private:
  void addChoice(QMenu &menu, Fading fading, const QString &text, const QString &explanation);
  void showChoice();
  void choose(Fading fading);
  void renewNumbers();
  void answer(const QString &lineId, const QString &text);
  void open(const QString &lineId);
  /// Shows what the practice has come to.
  void refresh();
  void showScore();

  StepWorking m_blocks;
  QToolButton *m_chooser;
  QActionGroup *m_choices;
  QToolButton *m_newNumbers;
  QLabel *m_score;
  LinePractice m_practice;
  std::vector<std::size_t> m_linesIn;
};

} // namespace halfspace
