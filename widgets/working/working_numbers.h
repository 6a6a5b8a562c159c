// The numbers of worked lines that can be touched: where they stand, and which is which.
#pragma once

#include "widgets/working/working_layout.h"

namespace halfspace {

/// A number in a worked line. It is found again when the line is of another scene.
struct NumberPlace {
  std::string line;
  LinePiece piece;
  Term number;     ///< as it was when it was found
  std::size_t nth; ///< among the numbers of the piece that come from the same
  /// Whether both are the same place, whatever number stands there.
  bool operator==(const NumberPlace &other) const;

  /// The coordinate that it is, or null.
  [[nodiscard]] const CoordinateSource *coordinate() const;
};

/// What is touched by a pointer so near, in pixels.
inline constexpr double touchMargin = 3;

/// A box with the room around it in which a pointer touches it.
[[nodiscard]] inline QRectF touchedRoom(const QRectF &box) {
  return box.adjusted(-touchMargin, -touchMargin, touchMargin, touchMargin);
}

/// Finds numbers among lines and where these are placed; both must outlive it. Numbers that a blank stands
/// for are not there.
class ShownNumbers {
public:
  ShownNumbers(const std::vector<TypesetLine> &lines, const PlacedWorking &placed)
      : m_lines(lines), m_placed(placed) {}

  /// The number that the pointer touches, in the coordinates of the placing.
  [[nodiscard]] std::optional<NumberPlace> at(QPointF position) const;
  /// The numbers of a line in the order of reading.
  [[nodiscard]] std::vector<NumberPlace> inLine(std::size_t line) const;
  /// Which line a number is in; nothing where it is not shown.
  [[nodiscard]] std::optional<std::size_t> lineOf(const NumberPlace &place) const;
  /// The number that stands there now; null where it is not shown.
  [[nodiscard]] const Term *numberAt(const NumberPlace &place) const;
  /// The room of a number, one box for each row that it reaches into; empty where it is not shown.
  [[nodiscard]] std::vector<QRectF> boxesOf(const NumberPlace &place) const;

private:
  struct Found {
    std::size_t line;
    std::size_t index; ///< in its piece
  };
  [[nodiscard]] NumberPlace placeOf(std::size_t line, LinePiece piece, std::size_t index) const;
  [[nodiscard]] std::optional<Found> find(const NumberPlace &place) const;

  const std::vector<TypesetLine> &m_lines;
  const PlacedWorking &m_placed;
};

} // namespace halfspace
