// Terms done wrongly, in one place each: what learners do, as rewritings.
#pragma once

#include "lessons/term/term.h"

#include <vector>

namespace halfspace {

enum class Slip : std::uint8_t {
  ReversedDifference, ///< b − a for a − b
  DroppedPart,        ///< a summand left out
  AddedInstead,       ///< a + b for a − b
  SubtractedInstead,  ///< a − b for a + b
  UpsideDown,         ///< q/p for p/q
  Undivided,          ///< p for p/q
  NoRoot,             ///< x for √x, n·n for |n|
  RootOfDivisor,      ///< p/√q for p/q: divided by a length where its square belongs
  NotSquared,         ///< x for x²
  LostSign,           ///< |x| for a negative number x
  OtherName           ///< one name for another of the term
};

/// A term with one slip in it.
struct WrongWay {
  Slip slip;
  Term whole;   ///< the term as the slip leaves it
  Term right;   ///< the part in which the slip is, as it should be
  Term instead; ///< and as the slip makes it
};

/// All single slips that the term invites, in the order of `Slip`.
[[nodiscard]] std::vector<WrongWay> wrongWays(const Term &term);

} // namespace halfspace
