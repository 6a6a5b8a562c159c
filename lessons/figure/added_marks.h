// What is new in a figure.
#pragma once

#include "lessons/figure/figure.h"

#include <set>

namespace halfspace {

/// The ids of the marks that a figure has, and the one before it does not.
[[nodiscard]] inline std::set<std::string> idsAdded(const Figure &before, const Figure &figure) {
  std::set<std::string> added;
  for (const Mark &mark : figure.marks)
    added.insert(baseOf(mark).id);
  for (const Mark &mark : before.marks)
    added.erase(baseOf(mark).id);
  return added;
}

} // namespace halfspace
