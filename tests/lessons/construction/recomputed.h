// What each construction should come to, calculated a second time by other formulas than the program's.
#pragma once

#include "tests/lessons/construction/latex_value.h"

#include "lessons/construction/construction.h"

#include <optional>
#include <set>
#include <span>
#include <variant>

namespace halfspace::test {

/// Numbers as x·|x|: that of a fraction and of a root are fractions alike, and tell the number.
using SignedSquares = std::vector<Rational>;

struct Recomputed {
  std::string caseName;
  bool degenerate = false;
  /// Exactly the values that the outcome has; those of a group as `perp.uu`.
  std::map<std::string, std::variant<SignedSquares, std::string, int>> values;
  /// What the formulas' names stand for.
  Names names;
  /// The unknowns of equations `0 = …`: somewhere, and where they satisfy it, if they can.
  Names unknowns;
  std::optional<Names> solution;
  /// Marks of arrows and pieces that have no length and are left out.
  std::set<std::string> vanished;
};

/// The signed square of p/√square.
[[nodiscard]] Rational signedSquare(const Rational &p, const Rational &square = 1);

/// Throws std::out_of_range for a construction that has no recomputation yet: add one here.
[[nodiscard]] Recomputed recompute(std::string_view construction, std::span<const Object *const> objects);

} // namespace halfspace::test
