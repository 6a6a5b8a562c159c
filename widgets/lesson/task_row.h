// A task of a lesson with the mark that says whether it is done.
#pragma once

#include "lessons/lesson/task_progress.h"
#include "widgets/picture/theme.h"
#include "widgets/text/rich_label.h"

namespace halfspace {

/// The instruction beside an empty circle, or a check mark once it is done. Of what holds already it says
/// that it is still to be brought about: else a learner would wait for the mark. One that waits for those
/// above it is paler.
class TaskRow : public QWidget {
  Q_OBJECT
public:
  TaskRow(const Typesetter &typesetter, const QString &instruction, QWidget *parent = nullptr);

  /// The instruction, in which live values are filled in.
  void setWords(const QString &markdown);
  /// While it is held it becomes no less high.
  void setHeld(bool held) { m_words->setHeld(held); }
  void setState(TaskState state);
  [[nodiscard]] TaskState state() const { return m_state; }
  void setTheme(const Theme &theme);

protected:
  void paintEvent(QPaintEvent *event) override;

private:
  void setInks();
  void tellAccessibly();

  RichLabel *m_words;
  RichLabel *m_holdsAlready;
  TaskState m_state = TaskState::Open;
  Theme m_theme;
};

} // namespace halfspace
