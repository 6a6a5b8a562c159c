// Coordinates changed where the lines of a block show them.
#pragma once

#include "widgets/numbers/scrub.h"
#include "widgets/working/block_layout.h"
#include "widgets/working/coordinate_changes.h"

#include <QWidget>

namespace halfspace {

class NumberField;

/// A number of the scene that is typed where a formula shows it.
struct TypedCoordinate {
  CoordinateSource number;
  Rational value;
};

/// One number at a time is scrubbed under the pointer, or typed in a field that stands in its place.
class CoordinateInput : public CoordinateChanges {
  Q_OBJECT
public:
  /// Why a typed text is not taken, in which line.
  struct Refusal {
    std::string line;
    QString sentence;
  };

  /// The field is a child of the block. Both must outlive it.
  CoordinateInput(QWidget &block, const BlockLayout &layout);

  // Scrubbed, by what the block hears of the mouse:
  void press(const CoordinateSource &number, const QMouseEvent &event);
  void move(const QMouseEvent &event) { m_scrub.move(event); }
  /// False: what was scrubbed is taken back.
  void endScrub(bool keep) { m_scrub.end(keep); }
  [[nodiscard]] bool isPressed() const { return m_scrub.isPressed(); }
  [[nodiscard]] bool isScrubbing() const { return m_scrub.isScrubbing(); }
  /// While a number is scrubbed the keys are the hand's: Escape takes it back. Whether one is scrubbed.
  bool useKey(int key);

  // Typed:
  /// Requires a number that is a coordinate; nothing happens where it is not shown.
  void openField(const NumberPlace &number);
  /// Takes back what is typed and not entered.
  void closeField();
  /// The lines have got new places, or other numbers: the field goes with its own.
  void followLines();
  /// What is typed and not entered yet; nothing where nothing is, or it would be refused.
  [[nodiscard]] std::optional<TypedCoordinate> typed() const;
  /// Ends a scrub, and enters what is typed and not entered yet. Why it is refused; else empty.
  [[nodiscard]] QString enter();
  [[nodiscard]] const std::optional<Refusal> &refusal() const { return m_refusal; }

signals:
  void refusalChanged();

private:
  void connectField(const CoordinateSource &number);
  void placeField();
  void refuse(const QString &sentence);

  QWidget &m_block;
  const BlockLayout &m_layout;
  Scrub m_scrub;
  CoordinateSource m_scrubbed;
  std::optional<NumberPlace> m_place; ///< of the number that is typed
  NumberField *m_field = nullptr;     ///< null while none is
  std::optional<Refusal> m_refusal;
};

} // namespace halfspace
