// Bounds of a number that is no A + B·√n. To compile it takes seconds: only who looks at bounds includes it.
#pragma once

#include "lessons/term/root_sum.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace halfspace {

/// Between `low` and `high`, both included; each operation widens by its own rounding.
struct Interval {
  /// Digits enough to tell any two numbers apart that a page shows, and then some.
  using Bound =
      boost::multiprecision::number<boost::multiprecision::cpp_bin_float<120>, boost::multiprecision::et_off>;
  Bound low;
  Bound high;
  /// The number itself, where it is a sum of roots: then the bounds tell its sign.
  std::optional<RootSum> number{};
};

} // namespace halfspace
