#include "widgets/working/step_coordinates.h"

namespace halfspace {

std::optional<TypedCoordinate> StepCoordinates::typed() const {
  for (WorkingBlock *block : m_blocks)
    if (auto typed = block->coordinates().typed())
      return typed;
  return {};
}

QString StepCoordinates::enter() {
  QString refused;
  for (WorkingBlock *block : m_blocks)
    if (const QString why = block->coordinates().enter(); refused.isEmpty())
      refused = why;
  return refused;
}

void StepCoordinates::drop() {
  for (WorkingBlock *block : m_blocks)
    block->coordinates().closeField();
}

} // namespace halfspace
