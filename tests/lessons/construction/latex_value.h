// What a formula's LaTeX says, calculated: the tests read the worked lines as a learner does, and calculate
// each side anew.
#pragma once

#include "geometry/surd.h"
#include "lessons/object/object.h"

#include <boost/multiprecision/cpp_dec_float.hpp>

#include <map>
#include <string>
#include <vector>

namespace halfspace::test {

namespace mp = boost::multiprecision;

/// A hundred digits: a number rounded for the page is seen at once, the calculation's own rounding never.
using Precise = mp::number<mp::cpp_dec_float<100>, mp::et_off>;

/// A number (one component) or a vector (three).
using Quantity = std::vector<Precise>;

/// What the names of a formula stand for, by their LaTeX: `\vec n`, `P_0`, `f(Q)`.
using Names = std::map<std::string, Quantity>;

[[nodiscard]] Quantity quantity(const Rational &number);
[[nodiscard]] Quantity quantity(const ExactVec3 &vector);
[[nodiscard]] Quantity quantity(const Surd &number);
/// number/√square
[[nodiscard]] Quantity quantityOverRoot(const Rational &number, const Rational &square);

/// One side of a relation, and the relation before it: `=`, `~` (≈), `?` (≠), `<`, `>`; none before the
/// first.
struct Side {
  char relation = ' ';
  std::string latex;
};

/// The sides of `a = b \approx c`. Lines joined by `\quad` are separate chains.
[[nodiscard]] std::vector<std::vector<Side>> chainsOf(const std::string &latex);

/// Calculates one side. Throws std::invalid_argument for what is no formula of these names.
[[nodiscard]] Quantity calculate(const std::string &latex, const Names &names);

} // namespace halfspace::test
