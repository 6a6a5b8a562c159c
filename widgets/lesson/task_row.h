// A task of a lesson with the mark that says whether it is done.
#pragma once

#include "lessons/lesson/task_progress.h"
#include "widgets/lesson/hint_column.h"

namespace halfspace {

/// The instruction beside an empty circle, or a check mark once it is done; then the answer to what it asks
/// stands below it, and until then how far the learner is, and hints. Of what holds already it says that it
/// is still to be brought about: else a learner would wait for the mark. One that waits for those above it is
/// paler.
class TaskRow : public QWidget {
  Q_OBJECT
public:
  explicit TaskRow(const Typesetter &typesetter, QWidget *parent = nullptr);

  /// All but the instruction may be empty, and are made when they are shown.
  void setWords(FilledMarkdown instruction, Lazy<FilledMarkdown> now, Lazy<FilledMarkdown> answer);
  /// As HintColumn has it.
  void setHints(std::vector<Lazy<FilledMarkdown>> hints);
  /// While it is held it becomes no less high.
  void setHeld(bool held);
  void setState(TaskState state);
  [[nodiscard]] TaskState state() const { return m_state; }
  /// Whether it is the learner's turn.
  [[nodiscard]] bool isDue() const;
  void setTheme(const Theme &theme);

  /// What a screen reader is told: what is to be done, and how far it is.
  [[nodiscard]] QString spokenName() const;
  [[nodiscard]] QString spokenDescription() const;

signals:
  void hintTold();

protected:
  void paintEvent(QPaintEvent *event) override;

private:
  /// Says below the instruction what is said there now; whether that is something else.
  bool showRemark();
  void showHints();
  void setInks();
  void tellScreenReader();

  RichLabel *m_words;
  RichLabel *m_remark;
  HintColumn *m_hints;
  Lazy<FilledMarkdown> m_now;
  Lazy<FilledMarkdown> m_answer;
  FilledMarkdown m_holdsAlready; ///< the sentence that says so
  TaskState m_state = TaskState::Open;
  Theme m_theme;
};

} // namespace halfspace
