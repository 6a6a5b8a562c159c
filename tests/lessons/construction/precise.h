// One side of a formula, calculated anew from its LaTeX.
#pragma once

#include "tests/lessons/construction/latex_value.h"

#include <boost/multiprecision/cpp_dec_float.hpp>

#include <string>
#include <vector>

namespace halfspace::test {

namespace mp = boost::multiprecision;

/// A hundred digits: a number rounded for the page is seen at once, the calculation's own rounding never.
using Precise = mp::number<mp::cpp_dec_float<100>, mp::et_off>;
using Numbers = std::vector<Precise>;

struct Components {
  Numbers numbers;
};

[[nodiscard]] Quantity quantity(Numbers numbers);

/// The components of one side. Throws std::invalid_argument for what is no formula of these names.
[[nodiscard]] Numbers calculate(const std::string &latex, const Names &names);

} // namespace halfspace::test
