// What stands between the brackets of a call in a typed line.
#pragma once

#include "lessons/formula/formula.h"
#include "lessons/typed/typed_fault.h"

namespace halfspace {

/// A formula, and the bytes of the line that it stands in.
struct Argument {
  Formula formula;
  std::size_t at = 0;
  std::size_t length = 0;
};

/// What is said of an argument.
[[nodiscard]] inline TypedFault faultAt(const Argument &argument, std::string sentence) {
  return {std::move(sentence), argument.at, argument.length};
}

/// A formula that was read on its own.
[[nodiscard]] inline Argument argumentOf(const Formula &formula) { return {formula, formula.at, 1}; }

/// Three numbers as one argument, a point or a vector.
[[nodiscard]] std::vector<Argument> asTriple(const std::vector<Argument> &numbers);

/// A plane through three points as what it is told by: one of them and its normal.
[[nodiscard]] std::vector<Argument> throughPoints(const std::vector<Argument> &points);

} // namespace halfspace
