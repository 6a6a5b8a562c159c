#include "widgets/picture/hand/drop_line.h"

namespace halfspace {

std::optional<DropLine> dropLineOf(const Handle &handle, bool numbersHidden) {
  const bool isGiven = handle.motion == Handle::Motion::Coordinate;
  const bool follows = handle.motion == Handle::Motion::OnHost;
  return isGiven || (follows && !numbersHidden) ? std::optional(DropLine{toDouble(handle.at)}) : std::nullopt;
}

} // namespace halfspace
