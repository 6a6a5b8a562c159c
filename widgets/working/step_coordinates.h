// Coordinates changed in any block of a step's working.
#pragma once

#include "widgets/working/working_block.h"

namespace halfspace {

/// Speaks for the coordinates of all blocks. At most one number is typed at a time.
class StepCoordinates : public CoordinateChanges {
  Q_OBJECT
public:
  /// The blocks must outlive it.
  explicit StepCoordinates(const std::vector<WorkingBlock *> &blocks) : m_blocks(blocks) {}

  /// The number that is typed in a formula and not entered yet; nothing where none is.
  [[nodiscard]] std::optional<TypedCoordinate> typed() const;
  /// Ends a scrub, and enters what is typed and not entered yet. Why it is refused; else empty.
  [[nodiscard]] QString enter();
  /// Takes back what is typed and refused.
  void drop();

private:
  const std::vector<WorkingBlock *> &m_blocks;
};

} // namespace halfspace
