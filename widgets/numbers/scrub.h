// Scrubbing: a number is pressed and dragged sideways, and changes step by step.
#pragma once

#include <QObject>
#include <QPoint>

class QMouseEvent;
class QWidget;

namespace halfspace {

/// Is told of the mouse by the widget that shows the number. While a number is scrubbed the widget has the
/// keyboard, even without the focus: Escape is meant for it.
class Scrub : public QObject {
  Q_OBJECT

public:
  explicit Scrub(QWidget &widget);

  /// A press on a number. It becomes a scrub when the pointer moves far enough.
  void press(const QMouseEvent &event);
  void move(const QMouseEvent &event);
  /// The button is up, or the press is to mean something else. False: Escape.
  void end(bool keep);

  /// From the press until the button is up.
  [[nodiscard]] bool isPressed() const { return m_isPressed; }
  [[nodiscard]] bool isScrubbing() const { return m_isScrubbing; }

signals:
  void started();
  void moved(int steps); ///< from where the scrub started
  void ended(bool keep);

private:
  QWidget &m_widget;
  bool m_isPressed = false;
  bool m_isScrubbing = false;
  QPoint m_pressedAt;
};

} // namespace halfspace
