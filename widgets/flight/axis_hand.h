// The mouse and the keys on a flight's axis.
#pragma once

#include "widgets/flight/axis_layout.h"

class QHelpEvent;
class QKeyEvent;
class QMouseEvent;

namespace halfspace {

/// Takes the events of an axis before the axis itself does: the torpedo is dragged, or moved by keys, and
/// crossings are pointed at and chosen. It only says what is wanted; nothing is while a question is open.
class AxisHand : public QObject {
  Q_OBJECT
public:
  /// Both must outlive it.
  AxisHand(QWidget &axis, const AxisLayout &layout);

  /// Takes the torpedo there, as a key does, unless it is dragged.
  void moveTo(double t);
  /// The button is up, or what it holds is let go.
  void endScrub(bool keep);
  /// From a press until the button is up.
  [[nodiscard]] bool isPressed() const { return m_grab.has_value(); }
  [[nodiscard]] bool isScrubbing() const { return m_grab && m_grab->isScrubbing; }

  /// The fragment that the pointer is on, here or somewhere else; 0 for none.
  [[nodiscard]] std::size_t hoveredNumber() const { return m_hovered; }
  void setHovered(std::size_t number);

signals:
  void scrubBegun();
  void scrubbed(double t);
  void released();            ///< nothing is held any more
  void scrubEnded(bool keep); ///< after that; false: Escape
  void chosen(std::size_t number);
  void hovered(std::size_t number); ///< 0: none any more

protected:
  bool eventFilter(QObject *watched, QEvent *event) override;

private:
  struct Grab {
    QPoint pressedAt;
    double offset = 0; ///< from the pointer to the tip, in pixels
    std::size_t pin = 0;
    bool isScrubbing = false;
  };

  // Whether the event has a meaning here.
  bool press(const QMouseEvent &event);
  bool useKey(const QKeyEvent &event);
  void move(const QMouseEvent &event);
  void release(const QMouseEvent &event);
  void pointAt(QPoint place);
  void hover(std::size_t number);
  void beginScrub();
  void scrubTo(double x, Qt::KeyboardModifiers modifiers);
  void stepBy(double ticks);
  void chooseNext(int direction);
  void showTip(const QHelpEvent &help);

  QWidget &m_axis;
  const AxisLayout &m_layout;
  std::optional<Grab> m_grab;
  std::size_t m_hovered = 0;
};

} // namespace halfspace
