// A calculation as the formulas that a program would go through one after the other. Worked lines show these
// formulas, and what the calculation costs is counted in them.
#pragma once

#include "lessons/construction/working.h"
#include "lessons/term/operations.h"

namespace halfspace {

/// What a step needs that not every case has.
enum class Needs : std::uint8_t {
  Nothing,
  Denominator, ///< to divide by: else the line goes up to the division
  Point        ///< else there is no line
};

struct Step {
  Chain chain; ///< its first side is the letter that it gives a value
  std::string sentence{};
  std::vector<WrongTerm> mistakes{};
  Needs needs = Needs::Nothing;
  Chain (*numbers)(const Chain &) = withNumbers; ///< how it goes on behind its symbols
};
using Steps = std::vector<Step>;

/// The line of a step. Where there is nothing to divide by, of a quotient what would be divided.
[[nodiscard]] WorkingLine lineOf(const Step &step, bool canDivide);

/// What a calculation costs: once, and again whenever what changes does.
struct Cost {
  Operations once;
  Operations eachTime;

  [[nodiscard]] Operations all() const { return once + eachTime; }
};

/// Steps count for each time that calculate with what changes, or with what was calculated from it.
[[nodiscard]] Cost costOf(const Steps &steps, std::vector<Term> changing);

} // namespace halfspace
