// What it costs to calculate formulas: their multiplications, additions, divisions and roots of numbers.
#pragma once

#include "lessons/term/term.h"

#include <vector>

namespace halfspace {

/// Operations on numbers. Subtractions are counted as additions, and a turned sign costs nothing.
struct Operations {
  int multiplications = 0;
  int additions = 0;
  int divisions = 0;
  int roots = 0;

  Operations &operator+=(const Operations &other);
  friend Operations operator+(Operations a, const Operations &b) { return a += b; }
  bool operator==(const Operations &) const = default;
};

/// Counts the operations of formulas that are calculated one after the other. What reads alike is calculated
/// once and kept; a name is there already.
class OperationCounter {
public:
  /// Those that the formula needs and no formula before it needed.
  Operations add(const Term &formula);

private:
  std::vector<Term> m_kept;
};

} // namespace halfspace
