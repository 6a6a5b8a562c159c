// Where a flight's axis has the torpedo and what the ray crosses.
#pragma once

#include "widgets/flight/axis_range.h"
#include "widgets/flight/crossing_look.h"

#include <QWidget>

#include <optional>
#include <vector>

namespace halfspace {

// Lengths of an axis, in units: sixteenths of the height of a line of words.
inline constexpr double axisMarkRadius = 4.2;
inline constexpr double axisLeftRoom = 22;    ///< for a torpedo at the low end
inline constexpr double axisRightRoom = 22;   ///< for the arrow and its letter
inline constexpr double axisNumbersBelow = 8; ///< the line

/// A crossing on the axis.
struct AxisPin {
  Crossing crossing;
  Standing standing = Standing::Outside;
  double t = 0;
  int level = 0; ///< pins that would cover each other stand on top of each other
  [[nodiscard]] bool isInTriangle() const;
};

/// Knows what an axis shows, and gives it places in the width and the type of a widget. While a question is
/// open it hides what the answer could be told by: the torpedo is at the start, and there are no pins.
class AxisLayout {
public:
  /// Beyond this end of the axis there are pins that it clips.
  enum class End { Low, High };

  /// The widget must outlive it.
  explicit AxisLayout(const QWidget &axis) : m_axis(axis) {}

  void setCrossings(const Crossings &crossings);
  /// The torpedo is at t; it would be at `elapsed` had it hit nothing.
  void setTime(double t, double elapsed);
  void setHidden(bool hidden) { m_hidden = hidden; }
  /// Gives all their places, after any change; in another range only if it may change.
  void settle(bool mayChangeRange);

  [[nodiscard]] bool isHidden() const { return m_hidden; }
  [[nodiscard]] double time() const { return m_hidden ? 0 : m_t; }
  [[nodiscard]] double elapsed() const { return m_elapsed; }
  /// By t.
  [[nodiscard]] const std::vector<AxisPin> &pins() const;
  /// The number of the fragment that is chosen, and where its crossing is among the pins.
  [[nodiscard]] std::size_t chosen() const { return m_chosen; }
  [[nodiscard]] std::optional<std::size_t> chosenPin() const;

  /// In pixels.
  [[nodiscard]] double unit() const;
  [[nodiscard]] AxisScale scale() const;
  [[nodiscard]] double lineY() const;
  [[nodiscard]] double height() const;
  /// The tip of the torpedo.
  [[nodiscard]] QPointF handle() const;
  [[nodiscard]] QPointF placeOf(const AxisPin &pin) const;
  [[nodiscard]] QPointF placeOf(End end) const;
  /// Where the mark of a fragment's crossing is; nothing where there is none.
  [[nodiscard]] std::optional<QPointF> placeOf(std::size_t number) const;
  /// The nearest to the axis first.
  [[nodiscard]] std::vector<const AxisPin *> clippedAt(End end) const;
  /// The pins that a place is about, the topmost first.
  [[nodiscard]] std::vector<const AxisPin *> pinsAt(QPointF place) const;

private:
  void stack();

  const QWidget &m_axis;
  std::vector<AxisPin> m_pins;
  int m_levels = 1;
  AxisRange m_range;
  double m_t = 0;
  double m_elapsed = 0;
  std::size_t m_chosen = 0;
  bool m_hidden = false;
};

} // namespace halfspace
