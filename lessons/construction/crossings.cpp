#include "lessons/construction/crossings.h"

#include <algorithm>

namespace halfspace {

const Crossing *nearestOf(const Crossings &crossings) {
  const auto found = std::find_if(crossings.all.begin(), crossings.all.end(), [&](const Crossing &crossing) {
    return crossing.number == crossings.nearest;
  });
  return found == crossings.all.end() ? nullptr : &*found;
}

} // namespace halfspace
