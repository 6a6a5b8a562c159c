// Marks on their way into a picture.
#pragma once

#include "lessons/figure/mark.h"

#include <set>

namespace halfspace {

/// Marks that fade in, and how far they have come.
struct Arrival {
  std::set<std::string> marks; ///< their ids
  double presence = 1;         ///< 0: not to be seen yet; 1: like all others

  [[nodiscard]] double presenceOf(const MarkBase &mark) const {
    return marks.contains(mark.id) ? presence : 1;
  }
};

} // namespace halfspace
