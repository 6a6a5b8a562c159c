// Formulas of numbers, points and vectors, as they are typed for a coordinate: 2k, (A + B)/2, E.n.
#pragma once

#include "lessons/object/object.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace halfspace {

/// What a formula comes to: a number; or three, those of a point or a vector.
using FormulaValue = std::variant<Rational, ExactVec3>;

/// Whether a value is one number or three.
enum class FormulaShape : std::uint8_t { Number, Triple };

enum class FormulaKind : std::uint8_t {
  Number,     ///< 3/2
  Name,       ///< k; E.n
  Component,  ///< Q.x: `number` is 0, 1 or 2
  Triple,     ///< (1, 2k, 3)
  Negative,   ///< −k
  Sum,        ///< of two
  Difference, ///< of two
  Product,    ///< of two numbers, or of a number and three
  Quotient,   ///< by a number
  Power,      ///< of a number, by a whole number from 0 on
  Dot,        ///< u · v of two vectors; with a number the same as a product
  Cross,      ///< u × v of two vectors
  Shortest    ///< shortest(v): in the direction of a vector, with whole numbers without a common factor
};

/// A formula as a tree. Two are equal that are built alike, wherever they were typed.
struct Formula {
  FormulaKind kind = FormulaKind::Number;
  Rational number{};            ///< of a number or of a component
  std::string name{};           ///< of a name
  std::vector<Formula> parts{}; ///< what it is made of, from left to right
  std::size_t at = 0;           ///< the byte at which it begins where it was read from

  bool operator==(const Formula &other) const {
    return kind == other.kind && number == other.number && name == other.name && parts == other.parts;
  }
};

/// Whether the formula is a number, and not made of others.
[[nodiscard]] inline bool isPlainNumber(const Formula &formula) {
  return formula.kind == FormulaKind::Number;
}

/// What keeps a formula from coming to something: a sentence, and the byte at which what it is about begins.
struct FormulaFault {
  std::string sentence;
  std::size_t at = 0;
};

/// The shape of what a name stands for; nothing where it stands for nothing.
using ShapeOfName = std::function<std::optional<FormulaShape>(std::string_view name)>;
/// Whether a formula comes to a number or to three, or what in it does not fit: an unknown name, a sum of a
/// number and a point. Of what fits only a division by zero is without a value.
[[nodiscard]] std::variant<FormulaShape, FormulaFault> shapeOf(const Formula &formula,
                                                               const ShapeOfName &shapeOfName);

/// What a name stands for now; nothing where that is not there.
using ValueOfName = std::function<std::optional<FormulaValue>(std::string_view name)>;
/// The value of a formula that fits; or why there is none now: a division by zero, or something that is not
/// there.
[[nodiscard]] std::variant<FormulaValue, FormulaFault> valueOf(const Formula &formula,
                                                               const ValueOfName &valueOfName);

/// Three numbers as a formula.
[[nodiscard]] Formula formulaOf(const ExactVec3 &numbers);

/// Calls a function with each name in a formula, from left to right.
template <class SomeFormula, class Function>
void forEachName(SomeFormula &formula, const Function &function) {
  if (formula.kind == FormulaKind::Name)
    function(formula.name);
  for (auto &part : formula.parts)
    forEachName(part, function);
}

/// A formula is read with at most so many bytes, and so deep.
inline constexpr std::size_t longestFormula = 4000;
inline constexpr int deepestFormula = 40;
/// The largest power.
inline constexpr int highestPower = 8;
/// The most numbers that a power multiplies with one another, powers within it counted: (k^8)^8.
inline constexpr int heaviestPower = 64;

} // namespace halfspace
