// A task of a lesson with the mark that says whether it is done.
#pragma once

#include "lessons/lesson/task_progress.h"
#include "widgets/picture/theme.h"
#include "widgets/text/rich_label.h"

namespace halfspace {

/// The instruction beside an empty circle, or a check mark once it is done; then the answer to what it asks
/// stands below it, and until then how far the learner is. Of what holds already it says that it is still to
/// be brought about: else a learner would wait for the mark. One that waits for those above it is paler.
class TaskRow : public QWidget {
  Q_OBJECT
public:
  explicit TaskRow(const Typesetter &typesetter, QWidget *parent = nullptr);

  /// All but the instruction may be empty.
  void setWords(FilledMarkdown instruction, FilledMarkdown now, FilledMarkdown answer);
  /// While it is held it becomes no less high.
  void setHeld(bool held);
  void setState(TaskState state);
  [[nodiscard]] TaskState state() const { return m_state; }
  void setTheme(const Theme &theme);

protected:
  void paintEvent(QPaintEvent *event) override;

private:
  /// What is said below the instruction.
  void showRemark();
  void setInks();
  void tellAccessibly();

  RichLabel *m_words;
  RichLabel *m_remark;
  FilledMarkdown m_now;
  FilledMarkdown m_answer;
  FilledMarkdown m_holdsAlready; ///< the sentence that says so
  TaskState m_state = TaskState::Open;
  Theme m_theme;
};

} // namespace halfspace
