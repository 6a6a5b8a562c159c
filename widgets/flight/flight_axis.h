// The ray's parameter as an axis, with what the ray crosses and the torpedo at the present t.
#pragma once

#include "widgets/flight/axis_hand.h"
#include "widgets/typeset/typesetter.h"

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
  void setHovered(std::size_t number) { m_hand.setHovered(number); }
  /// While it is held, or the torpedo dragged, the range stays as it is.
  void setHeld(bool held);
  void setTheme(const Theme &theme);

  /// Takes the torpedo there, as a key does. Nothing happens while a question is open, or while it is
  /// dragged.
  void moveTo(double t) { m_hand.moveTo(t); }
  [[nodiscard]] bool isScrubbing() const { return m_hand.isScrubbing(); }

  /// What it shows and where.
  [[nodiscard]] const AxisLayout &placed() const { return m_layout; }
  /// Where the torpedo is, as it is read: λ ≈ 0.33, or λ = ? while a question is open.
  [[nodiscard]] QString readout() const;
  /// What the ray crosses, each in a sentence; nothing while a question is open.
  [[nodiscard]] QStringList spokenCrossings() const;

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

signals:
  void scrubBegun();
  void scrubbed(double t);
  void scrubEnded(bool keep); ///< false: Escape
  void chosen(std::size_t number);
  void hovered(std::size_t number); ///< 0: none any more

protected:
  void paintEvent(QPaintEvent *event) override;
  void resizeEvent(QResizeEvent *event) override;
  void focusInEvent(QFocusEvent *event) override;
  void changeEvent(QEvent *event) override;

private:
  void connectHand();
  void sayChosen(); ///< by the axis' accessible name
  void settle();

  Typesetter::Picture m_letter;
  Typesetter::Picture m_letterQ;
  AxisLayout m_layout{*this};
  AxisHand m_hand{*this, m_layout};
  bool m_held = false;
  Theme m_theme;
};

} // namespace halfspace
