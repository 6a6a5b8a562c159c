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

} // namespace halfspace
