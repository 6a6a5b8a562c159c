// What each construction should come to: its numbers by other formulas than the program's, and
// wrong answers as learners come to them. One file a construction, by the words of lessons/CMakeLists.txt.
#pragma once

#include "tests/lessons/construction/latex_value.h"

#include "lessons/construction/construction.h"

#include <optional>
#include <set>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace halfspace::test {

using Objects = std::span<const Object *const>;

/// Numbers as x·|x|: that of a fraction and of a root are fractions alike, and tell the number.
using SignedSquares = std::vector<Rational>;

/// The signed square of p/√square.
[[nodiscard]] inline Rational signedSquare(const Rational &p, const Rational &square = 1) {
  return p * abs(p) / square;
}

/// Numbers A + B·√n, each as A and the signed square of B·√n, which need not be in their shortest form.
struct SumWithRoot {
  Rational number;
  Rational signedSquare;
};
using SumsWithRoots = std::vector<SumWithRoot>;

struct Recomputed {
  std::string caseName;
  bool degenerate = false;
  /// Exactly the values that the outcome has; those of a group as `perp.uu`.
  std::map<std::string, std::variant<SignedSquares, SumsWithRoots, std::string, int>> values;
  /// What the formulas' names stand for.
  Names names;
  /// The unknowns of equations `0 = …`: somewhere, and where they satisfy it, if they can.
  Names unknowns;
  std::optional<Names> solution;
  /// By lines whose equations have others, by their own ids.
  std::map<std::string, Names> solutions;
  /// Marks of arrows and pieces that have no length and are left out.
  std::set<std::string> vanished;
};

/// One thing done wrongly in one line.
struct WrongAnswer {
  std::string line; ///< the id of the worked line
  std::string how;  ///< what was done wrongly, in a few words: the same for all scenes
  std::string typed;
};

struct Expected {
  Recomputed (*recompute)(Objects);
  /// The wrong answers to the lines that ask for a number, without those that come to the right answer all
  /// the same. One value may come up for several reasons. None for a scene without an answer of the usual
  /// kind.
  std::vector<WrongAnswer> (*wrongAnswers)(Objects);
  double leastShareNamed; ///< of the distinct wrong answers so many are told what went wrong
};

/// Of a construction by its word: signed_distance.
[[nodiscard]] const Expected &expectedOf(const Construction &construction);

} // namespace halfspace::test
