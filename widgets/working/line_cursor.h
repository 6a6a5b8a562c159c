// Where the keys are in the lines of a block.
#pragma once

#include "widgets/working/block_layout.h"

#include <QWidget>

#include <functional>

namespace halfspace {

/// The line that was clicked or reached by the keys, and the number that the keys have chosen in it.
class LineCursor : public QObject {
  Q_OBJECT
public:
  /// Both must outlive it.
  LineCursor(QWidget &block, const BlockLayout &layout) : m_block(block), m_layout(layout) {}

  [[nodiscard]] std::optional<std::size_t> line() const { return m_line; }
  [[nodiscard]] const std::optional<NumberPlace> &chosen() const { return m_chosen; }
  /// The number that is chosen as it is now; null where none is, or it is not shown.
  [[nodiscard]] const Term *chosenNumber() const;

  /// Goes to a line, or to none.
  void goTo(std::optional<std::size_t> line);
  /// Goes to the line of a number without scrolling: it stays under the pointer.
  void goToLineOf(const NumberPlace &number);
  /// Lets go of the number that is chosen.
  void endChoice();
  /// Other lines are shown: a line that is not there any more is no place to be.
  void followLines();

  /// Up and Down go from line to line, Left and Right choose numbers, Enter uses the one that is chosen.
  /// Whether the key had a meaning.
  bool useKey(int key);
  /// What the keys do beyond the last line (way 1) and before the first (−1): whether they have gone on.
  void setGoOn(std::function<bool(int way)> goOn) { m_goOn = std::move(goOn); }
  /// The keys come from a block above (way 1) or below (−1), to the nearest line. False where there is none.
  bool comeIn(int way);

signals:
  void changed();       ///< another line, or another number
  void choiceChanged(); ///< another number, or none
  void chosenUsed(const halfspace::NumberPlace &number);
  /// The keys have come to this place: it is to be in view.
  void reached(const QRect &place);

private:
  bool step(int way);
  /// Chooses the number beside the one that is chosen in the current line; false where it has none.
  bool chooseBeside(int way);
  bool useChosen();

  QWidget &m_block;
  const BlockLayout &m_layout;
  std::function<bool(int way)> m_goOn;
  std::optional<std::size_t> m_line;
  std::optional<NumberPlace> m_chosen;
};

} // namespace halfspace
