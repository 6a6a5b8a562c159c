// An entry of a scene in a row of a list: what it is, and what it comes to.
#pragma once

#include "lessons/scene/evaluation.h"

namespace halfspace {

struct EntrySummary {
  /// As it is typed, behind the name, without its look, but whether it is locked: `midpoint(A, B)`; of a mesh
  /// the noun of its kind.
  std::string definition;
  /// What that comes to, where the definition does not say it: a plane's equation, the coordinates of what
  /// follows others, the number that a construction leads to, or its case in words; what is wrong with it.
  /// Empty for nothing.
  std::string value;
};

/// Of an entry of the scene that was evaluated.
[[nodiscard]] EntrySummary summaryOf(const Entry &entry, const Evaluation &evaluation,
                                     char decimalMark = '.');

/// What an object that an entry makes comes to: the coordinates, or the equation of a plane. Empty where it
/// is not there in the present case.
[[nodiscard]] std::string valueOf(const OfferedObject &object);

} // namespace halfspace
