// A slider for a number of the scene.
#pragma once

#include "widgets/session_model.h"

#include <QTimer>
#include <QWidget>

#include <optional>

class QSlider;
class QToolButton;

namespace halfspace {

struct NumberObject;

/// Moves a number between its bounds in its steps, by the hand, or by itself: from end to end and back, until
/// it is stopped. What is done in one go is one undo step.
class NumberSlider : public QWidget {
  Q_OBJECT
public:
  /// The model must outlive it.
  explicit NumberSlider(SessionModel &model, QWidget *parent = nullptr);

  /// The entry whose number it moves; hidden where that is none with bounds.
  void setNumber(const std::string &name);

private:
  void showNumber();
  [[nodiscard]] std::optional<NumberObject> number() const;
  void begin();
  void end();
  void moveTo(int step);
  void play(bool on);
  void step();

  SessionModel &m_model;
  std::string m_name;
  QSlider *m_slider;
  QToolButton *m_play;
  QTimer m_clock;
  int m_direction = 1; ///< in which it plays
  GestureToken m_gesture = GestureToken::Nobodys;
};

} // namespace halfspace
