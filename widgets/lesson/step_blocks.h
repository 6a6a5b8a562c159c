// The blocks of one step on the page.
#pragma once

#include "lessons/lesson/glossary.h"
#include "widgets/lesson/flight_blocks.h"
#include "widgets/lesson/prediction_box.h"
#include "widgets/lesson/task_row.h"
#include "widgets/when_seen.h"

class QVBoxLayout;

namespace halfspace {

class NoteFold;
class StepWorking;
class TermLinks;

/// Words, worked lines, question and tasks, in the order of the lesson. They are made for one step.
class StepBlocks : public QWidget {
  Q_OBJECT
public:
  /// The lines and the flight forget the blocks that they had, and get those of this step. All must outlive
  /// it but the step and the glossary, to which its words lead.
  StepBlocks(const Typesetter &typesetter, const LessonStep &step, const Glossary &glossary,
             LessonPictures pictures, StepWorking &working, FlightBlocks &flight);

  /// Sets the words with what their live values are now, which are asked for again where words come into
  /// sight.
  void showWords(LiveValueOf valueOf);
  /// Of the tasks in their order; of those behind them nothing is known. The task that is due once another is
  /// done is to be in view.
  void setTaskStates(const std::vector<TaskState> &states);
  /// To the question, if there is one; nothing: it is open. What stands behind an open question would often
  /// answer it, and is not shown.
  void setAnswer(const std::optional<GivenAnswer> &answer);
  /// While they are held none becomes less high.
  void setHeld(bool held);
  void setTheme(const Theme &theme);
  /// Between blocks, in pixels.
  void setGap(int gap);

signals:
  void predictionChosen(const QString &word);
  void predictionReopened(); ///< the learner wants to try the question again
  /// A part has something new to read: it is to be in view.
  void reached(const QWidget *part);

private:
  /// The column of what stands behind the question, the last of this one.
  [[nodiscard]] QVBoxLayout *columnBehindQuestion(QVBoxLayout &column);
  [[nodiscard]] QWidget *blockOf(const StepWords &words, TermLinks &links);
  [[nodiscard]] QWidget *blockOf(const StepLines &lines);
  [[nodiscard]] QWidget *blockOf(const StepNote &note);
  [[nodiscard]] QWidget *blockOf(const Task &task);
  [[nodiscard]] QWidget *blockOf(const Prediction &prediction);
  template <class Block> [[nodiscard]] QWidget *blockOf(const Block &ofFlight) {
    return m_flight.addBlock(ofFlight);
  }
  /// A label is to show these words.
  void add(Markdown words, RichLabel &label);
  [[nodiscard]] Lazy<FilledMarkdown> filledWhenSeen(const MarkdownText &words) const;

  /// The words of a label or of a task, which become others where they have live values.
  struct FilledWords {
    std::unique_ptr<WhenSeen> words;
    bool areLive;
  };

  const Typesetter &m_typesetter;
  LessonPictures m_pictures;
  StepWorking &m_working;
  FlightBlocks &m_flight;
  LiveValueOf m_valueOf; ///< empty before the first are shown
  std::vector<FilledWords> m_filled;
  std::vector<RichLabel *> m_labels;
  std::vector<NoteFold *> m_notes;
  std::vector<TaskRow *> m_tasks;
  const TaskRow *m_dueTask = nullptr;    ///< null while none is known, or all are done
  PredictionBox *m_prediction = nullptr; ///< null in steps without one
  QWidget *m_behindQuestion = nullptr;   ///< null where nothing stands there
};

} // namespace halfspace
