// What the names of a formula stand for, and what its LaTeX says: the tests read the worked lines as a
// learner does.
#pragma once

#include "geometry/surd.h"
#include "lessons/object/object.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace halfspace::test {

/// The components of a quantity: `precise.h` says what they are. Few need it, and it takes seconds to
/// compile.
struct Components;

/// A number (one component), a vector (three) or a line (six), never null.
using Quantity = std::shared_ptr<const Components>;

/// What the names of a formula stand for, by their LaTeX: `\vec n`, `P_0`, `f(Q)`.
using Names = std::map<std::string, Quantity>;

[[nodiscard]] Quantity quantity(const Rational &number);
[[nodiscard]] Quantity quantity(const ExactVec3 &vector);
[[nodiscard]] Quantity quantity(const Surd &number);
/// number/√square
[[nodiscard]] Quantity quantityOverRoot(const Rational &number, const Rational &square);
/// vector/√square
[[nodiscard]] Quantity quantityOverRoot(const ExactVec3 &vector, const Rational &square);
/// Of all their components.
[[nodiscard]] Quantity together(const std::vector<Quantity> &quantities);

/// One side of a relation, and the relation before it: `=`, `~` (≈), `?` (≠), `<`, `>`; none before the
/// first.
struct Side {
  char relation = ' ';
  std::string latex;
};

/// The sides of `a = b \approx c`. Lines joined by `\quad` are separate chains.
[[nodiscard]] std::vector<std::vector<Side>> chainsOf(const std::string &latex);

} // namespace halfspace::test
