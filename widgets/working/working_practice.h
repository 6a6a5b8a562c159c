// How much of the worked lines the learner completes, and what came of it.
#pragma once

#include "lessons/lesson/practice.h"
#include "widgets/working/step_working.h"

#include <map>

class QActionGroup;
class QLabel;
class QMenu;
class QToolButton;

namespace halfspace {

/// A row of tools: the choice of how much is blank, new numbers, the score. Keeps for every step of every
/// lesson which lines the learner has completed or had shown; they stay open until their numbers change, and
/// choosing how much is blank makes them blank anew, as do new numbers. Lines that are blank stay so and ask
/// for the new number; what was said about the one before stays, as such. A choice holds for its lesson.
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

  /// Whether some lines ask to be filled in.
  [[nodiscard]] bool hasBlanks() const { return !m_fade.gaps.empty(); }

signals:
  /// The learner has chosen, completed a line, or had one shown.
  void blanksChanged();
  /// The learner wants to work with other numbers. Whoever has the scene gives it some at once.
  void newNumbersRequested();

private:
  /// What the learner did with a line.
  struct LineRecord {
    std::string text;       ///< of the line then
    bool isOpen = false;    ///< completed, or shown
    LineRemark remark{};    ///< said about the last answer
    bool isCounted = false; ///< there was an answer, or the line was shown instead
  };
  /// Of all blanks of a step since the learner chose them, whatever numbers they asked for.
  struct Score {
    int right = 0; ///< at the first try
    int tried = 0; ///< answered or shown
  };
  struct StepPractice {
    std::optional<Fading> fading; ///< the learner's choice here
    std::map<std::string, LineRecord> lines;
    Score score;
  };

  void addChoice(QMenu &menu, Fading fading, const QString &text, const QString &explanation);
  void showChoice();
  void choose(Fading fading);
  void renewNumbers();
  void answer(const QString &lineId, const QString &text);
  void open(const QString &lineId);
  void refresh();
  /// What was done with other numbers is of no use for these: only what was said is kept.
  void endRecordsOfOtherNumbers();
  void count(LineRecord &record, bool right);
  void showScore();
  [[nodiscard]] Fading fading() const;
  [[nodiscard]] std::set<std::string> openedLines();
  /// What a line says with the present numbers; empty where there is no such line.
  [[nodiscard]] std::string textOf(const std::string &lineId) const;
  [[nodiscard]] std::map<std::string, LineRemark> remarks();
  /// What the learner did with the line, whose numbers are the present ones.
  [[nodiscard]] LineRecord &recordOf(const std::string &lineId);
  [[nodiscard]] StepPractice &practice() { return m_practice[m_step]; }

  StepWorking m_blocks;
  QToolButton *m_chooser;
  QActionGroup *m_choices;
  QToolButton *m_newNumbers;
  QLabel *m_score;
  std::map<std::string, Fading> m_chosen; ///< the learner's last choice in a lesson
  std::optional<Fading> m_asked;          ///< by the step
  std::pair<std::string, int> m_step;
  std::map<std::pair<std::string, int>, StepPractice> m_practice;
  Working m_working;
  std::vector<std::size_t> m_linesIn;
  bool m_hidden = false;
  Fade m_fade;
};

} // namespace halfspace
