// The way back and on, below the blocks of a step.
#pragma once

#include "widgets/picture/theme.h"

#include <QHBoxLayout>

#include <array>

class QPushButton;
class QSpacerItem;

namespace halfspace {

class StepDots;

/// Two buttons, and a dot for each step between them. Behind the last step the way on leads to the next
/// lesson, where there is one. It only says where the learner wants to go.
class PageFoot : public QHBoxLayout {
  Q_OBJECT
public:
  PageFoot();

  /// The titles of a lesson's steps.
  void setSteps(const QStringList &titles);
  void setStep(int step);
  /// What the way on leads to behind the last step; empty: nowhere.
  void setNextLesson(const QString &title);
  void setTheme(const Theme &theme);
  /// Below lines of words that are so much narrower than the page, in pixels on each side.
  void setRoomBeside(int besideLines);

  /// Gives the focus to the way on; false where there is none.
  bool focusNext();

signals:
  void stepRequested(int step);
  void nextLessonRequested();

private:
  void showNext();
  void keepButtonsWhole();
  void goOn();

  std::array<QSpacerItem *, 2> m_sides{};
  QPushButton *m_back;
  StepDots *m_dots;
  QPushButton *m_next;
  int m_step = 0;
  int m_stepCount = 0;
  QString m_nextLesson;
  double m_scale = 1; ///< of lengths, as the theme's text
};

} // namespace halfspace
