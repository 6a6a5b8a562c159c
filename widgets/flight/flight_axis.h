// The ray's parameter as an axis, with what the ray crosses and the torpedo at the present t.
#pragma once

#include "lessons/lesson/lesson.h"
#include "widgets/flight/axis_range.h"
#include "widgets/flight/crossing_look.h"
#include "widgets/typeset/typesetter.h"

#include <QWidget>

#include <optional>
#include <vector>

class QHelpEvent;

namespace halfspace {

/// The torpedo can be dragged along the axis, and moved by keys; crossings can be pointed at and chosen. It
/// is told where the torpedo is, and only says where it is wanted.
class FlightAxis : public QWidget {
  Q_OBJECT
public:
  /// The typesetter must outlive the axis.
  explicit FlightAxis(const Typesetter &typesetter, QWidget *parent = nullptr);

  void setCrossings(const Crossings &crossings);
  /// The torpedo is at t; keys go on from what has elapsed, which is more while it explodes.
  void setTime(double t, double elapsed);
  /// While a question is open: the torpedo waits at the start and nothing that the ray crosses is shown.
  void setHidden(bool hidden);
  /// The pointer is on this fragment somewhere else; 0 for none.
  void setHovered(std::size_t number);
  /// While it is held, or the torpedo dragged, the range stays as it is.
  void setHeld(bool held);
  void setTheme(const Theme &theme);

  /// Takes the torpedo there, as a key does. Nothing happens while a question is open, or while it is
  /// dragged.
  void moveTo(double t);

  /// Where the torpedo is: at the start while a question is open.
  [[nodiscard]] double time() const { return m_hidden ? 0 : m_t; }
  /// The same as it is read: λ ≈ 0.33, or λ = ? while a question is open.
  [[nodiscard]] QString readout() const;
  /// What the ray crosses, each in a sentence; nothing while a question is open.
  [[nodiscard]] QStringList spokenCrossings() const;
  [[nodiscard]] AxisScale scale() const;
  [[nodiscard]] bool isScrubbing() const { return m_grab && m_grab->isScrubbing; }
  /// Where the mark of a fragment's crossing is; nothing where there is none.
  [[nodiscard]] std::optional<QPointF> placeOf(std::size_t number) const;
  /// The tip of the torpedo.
  [[nodiscard]] QPointF handle() const;

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

signals:
  void scrubBegun();
  void scrubbed(double t);
  void scrubEnded(bool keep); ///< false: Escape
  void chosen(std::size_t number);
  void hovered(std::size_t number); ///< 0: none any more

protected:
  bool event(QEvent *event) override;
  void paintEvent(QPaintEvent *event) override;
  void resizeEvent(QResizeEvent *event) override;
  void mousePressEvent(QMouseEvent *event) override;
  void mouseMoveEvent(QMouseEvent *event) override;
  void mouseReleaseEvent(QMouseEvent *event) override;
  void leaveEvent(QEvent *event) override;
  void keyPressEvent(QKeyEvent *event) override;
  void focusInEvent(QFocusEvent *event) override;
  void focusOutEvent(QFocusEvent *event) override;
  void changeEvent(QEvent *event) override;

private:
  /// A crossing as it is painted.
  struct Pin {
    Crossing crossing;
    Standing standing = Standing::Outside;
    double t = 0;
    int level = 0; ///< pins that would cover each other stand on top of each other
    [[nodiscard]] bool isInTriangle() const;
  };
  struct Grab {
    QPoint pressedAt;
    double offset = 0; ///< from the pointer to the tip, in pixels
    std::size_t pin = 0;
    bool isScrubbing = false;
  };
  /// Clipped at an end of the axis.
  enum class End { Low, High };

  void sayChosen(); ///< by the axis' accessible name
  void settleRange();
  void stackPins();
  [[nodiscard]] double unit() const;
  [[nodiscard]] double lineY() const;
  [[nodiscard]] QPointF placeOf(const Pin &pin) const;
  [[nodiscard]] QPointF placeOf(End end) const;
  [[nodiscard]] std::vector<const Pin *> clippedAt(End end) const;
  /// Where the chosen crossing is among the pins.
  [[nodiscard]] std::optional<std::size_t> chosenPin() const;
  /// The pins that a place is about, the topmost first.
  [[nodiscard]] std::vector<const Pin *> pinsAt(QPointF place) const;
  [[nodiscard]] bool isOnHandle(QPointF place) const;

  void pointAt(QPoint place);
  void beginScrub();
  void scrubTo(double x, Qt::KeyboardModifiers modifiers);
  void endScrub(bool keep);
  void stepBy(double ticks);
  void chooseNext(int direction);
  [[nodiscard]] double snapped(double t, double x) const;
  void showTip(const QHelpEvent &help);

  void paintLine(QPainter &painter) const;
  void paintTicks(QPainter &painter) const;
  void paintPin(QPainter &painter, const Pin &pin) const;
  void paintEnd(QPainter &painter, End end) const;
  void paintHandle(QPainter &painter) const;
  void paintLetter(QPainter &painter, const MathPicture &picture, QPointF topMiddle, Color ink) const;

  Typesetter::Picture m_letter;
  Typesetter::Picture m_letterQ;
  std::vector<Pin> m_pins; ///< by t
  int m_levels = 1;
  AxisRange m_range;
  double m_t = 0;
  double m_elapsed = 0;
  std::size_t m_chosen = 0;
  std::size_t m_hovered = 0;
  bool m_hidden = false;
  bool m_held = false;
  std::optional<Grab> m_grab; ///< from a press until the button is up
  Theme m_theme;
};

} // namespace halfspace
