// Who is asked what in the worked lines of a lesson's steps, and what came of it.
#pragma once

#include "lessons/lesson/practice.h"

#include <map>
#include <utility>

namespace halfspace {

/// What is said about a line to the learner who filled it in.
struct AnswerRemark {
  std::string text;
  bool right = false;
  bool isOfNow = true; ///< the numbers are still those that were asked for
  bool operator==(const AnswerRemark &) const = default;
};

/// Keeps for every step of every lesson which lines the learner has completed or had shown; they stay open
/// until their numbers change, and choosing how much is blank makes them blank anew, as do new numbers. Lines
/// that are blank stay so and ask for the new number; what was said about the one before stays, as such. A
/// choice holds for its lesson.
class LinePractice {
public:
  /// Of all blanks of a step since the learner chose them, whatever numbers they asked for.
  struct Score {
    int right = 0; ///< at the first try
    int tried = 0; ///< answered or shown
    bool operator==(const Score &) const = default;
  };

  /// The lesson and step whose lines come next; `asked` is what the step leaves to the learner if it says so.
  /// False where it is the same step as before.
  bool setStep(const std::string &lesson, int step, std::optional<Fading> asked);
  /// Other numbers, or other lines. `hidden`: no line shows numbers or asks for them, because a question goes
  /// before.
  void setWorking(const Working &working, bool hidden);

  /// The learner's choice, in this step and in those of the lesson that leave nothing to the learner.
  void choose(Fading fading);
  /// What was done is about numbers that go; the score stays.
  void forgetLines();
  /// Judges what was typed into a line's blank; false where the line has none.
  bool answer(const std::string &line, const std::string &typed);
  /// Shows a line, which counts as tried.
  void open(const std::string &line);

  [[nodiscard]] const Working &working() const { return m_working; }
  [[nodiscard]] bool isHidden() const { return m_hidden; }
  [[nodiscard]] Fading fading() const;
  /// What is blank now.
  [[nodiscard]] const Fade &fade() const { return m_fade; }
  /// Whether the lines have a number that can be left to the learner.
  [[nodiscard]] bool hasNumbersToFind() const { return m_hasNumbersToFind; }
  [[nodiscard]] Score score() const;
  /// By the lines' ids; none while numbers are hidden.
  [[nodiscard]] std::map<std::string, AnswerRemark> remarks() const;

private:
  /// What the learner did with a line.
  struct LineRecord {
    std::string text;       ///< of the line then
    bool isOpen = false;    ///< completed, or shown
    AnswerRemark remark{};  ///< said about the last answer
    bool isCounted = false; ///< there was an answer, or the line was shown instead
  };
  struct StepRecord {
    std::optional<Fading> fading{}; ///< the learner's choice here
    std::map<std::string, LineRecord> lines{};
    Score score{};
  };
  using Step = std::pair<std::string, int>;

  void refresh();
  /// What was done with other numbers is of no use for these: only what was said is kept.
  void endRecordsOfOtherNumbers();
  void count(LineRecord &record, bool right);
  [[nodiscard]] std::set<std::string> openedLines();
  /// What a line says with the present numbers; empty where there is no such line.
  [[nodiscard]] std::string textOf(const std::string &line) const;
  /// What the learner did with the line, whose numbers are the present ones.
  [[nodiscard]] LineRecord &recordOf(const std::string &line);
  [[nodiscard]] StepRecord &here() { return m_records[m_step]; }

  std::map<std::string, Fading> m_chosen; ///< the learner's last choice in a lesson
  std::map<Step, StepRecord> m_records;
  Step m_step;
  std::optional<Fading> m_asked; ///< by the step
  Working m_working;
  bool m_hidden = false;
  bool m_hasNumbersToFind = false;
  Fade m_fade;
};

} // namespace halfspace
