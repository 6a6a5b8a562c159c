// Bounds of a number that no exact form holds. To compile it takes seconds: only who looks at bounds includes
// it.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace halfspace {

/// Between `low` and `high`, both included; each operation widens by its own rounding.
struct Interval {
  /// Digits enough to tell any two numbers apart that a page shows, and then some.
  using Bound =
      boost::multiprecision::number<boost::multiprecision::cpp_bin_float<120>, boost::multiprecision::et_off>;
  Bound low;
  Bound high;
};

} // namespace halfspace
