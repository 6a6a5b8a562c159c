#include "lessons/formula/formula.h"

#include "geometry/plane.h"
#include "lessons/words.h"

#include <utility>

namespace halfspace {
namespace {

FormulaFault unknownName(const Formula &formula) {
  return {words("There is no “{name}” here.", {{"name", formula.name}}), formula.at};
}

/// Finds what of a formula does not fit.
class ShapeFinder {
public:
  using Found = std::variant<FormulaShape, FormulaFault>;

  explicit ShapeFinder(const ShapeOfName &shapeOfName) : m_shapeOfName(shapeOfName) {}

  Found find(const Formula &formula) const {
    if (formula.kind == FormulaKind::Number)
      return FormulaShape::Number;
    if (formula.kind == FormulaKind::Name)
      return ofName(formula);
    std::vector<FormulaShape> shapes;
    for (const Formula &part : formula.parts) {
      Found found = find(part);
      if (std::holds_alternative<FormulaFault>(found))
        return found;
      shapes.push_back(std::get<FormulaShape>(found));
    }
    return ofParts(formula, shapes);
  }

private:
  Found ofName(const Formula &formula) const {
    const auto shape = m_shapeOfName(formula.name);
    return shape ? Found(*shape) : unknownName(formula);
  }

  static Found expectAll(const std::vector<FormulaShape> &shapes, const Formula &formula,
                         FormulaShape expected, FormulaShape result, const std::string &sentence) {
    for (std::size_t i = 0; i < shapes.size(); ++i)
      if (shapes[i] != expected)
        return FormulaFault{sentence, formula.parts[i].at};
    return result;
  }

  static Found ofParts(const Formula &formula, const std::vector<FormulaShape> &shapes) {
    using enum FormulaShape;
    switch (formula.kind) {
    case FormulaKind::Component:
      return expectAll(shapes, formula, Triple, Number, words("Only a point or a vector has x, y and z."));
    case FormulaKind::Triple:
      return expectAll(shapes, formula, Number, Triple,
                       words("Here a number is needed, not a point or a vector."));
    case FormulaKind::Sum:
    case FormulaKind::Difference:
      if (shapes[0] != shapes[1])
        return FormulaFault{words("A number and a point cannot be added."), formula.parts[1].at};
      return shapes[0];
    case FormulaKind::Product:
      if (shapes[0] == Triple && shapes[1] == Triple)
        return FormulaFault{words("Vectors have two products: u · v is a number, u × v a vector."),
                            formula.at};
      return shapes[0] == Number ? shapes[1] : Triple;
    case FormulaKind::Quotient:
      if (shapes[1] != Number)
        return FormulaFault{words("Nothing can be divided by a point or a vector."), formula.parts[1].at};
      return shapes[0];
    case FormulaKind::Power:
      return expectAll(shapes, formula, Number, Number, words("A point or a vector has no powers."));
    case FormulaKind::Dot:
      return shapes[0] == Triple && shapes[1] == Triple ? Number : shapes[0] == Number ? shapes[1] : Triple;
    case FormulaKind::Cross:
      return expectAll(shapes, formula, Triple, Triple, words("The product × is for two vectors."));
    case FormulaKind::Shortest:
      return expectAll(shapes, formula, Triple, Triple,
                       words("Only vectors have a shortest one of whole numbers."));
    default: // a sign changes no shape
      return shapes[0];
    }
  }

  const ShapeOfName &m_shapeOfName;
};

/// Values of formulas that fit.
class Calculator {
public:
  using Found = std::variant<FormulaValue, FormulaFault>;

  explicit Calculator(const ValueOfName &valueOfName) : m_valueOfName(valueOfName) {}

  Found find(const Formula &formula) const {
    if (formula.kind == FormulaKind::Number)
      return FormulaValue(formula.number);
    if (formula.kind == FormulaKind::Name)
      return ofName(formula);
    std::vector<FormulaValue> values;
    for (const Formula &part : formula.parts) {
      Found found = find(part);
      if (std::holds_alternative<FormulaFault>(found))
        return found;
      values.push_back(std::move(std::get<FormulaValue>(found)));
    }
    if (formula.kind == FormulaKind::Quotient && number(values[1]) == 0)
      return FormulaFault{words("This would be divided by zero."), formula.parts[1].at};
    return ofParts(formula, values);
  }

private:
  Found ofName(const Formula &formula) const {
    auto value = m_valueOfName(formula.name);
    return value ? Found(std::move(*value)) : unknownName(formula);
  }

  static const Rational &number(const FormulaValue &value) { return std::get<Rational>(value); }
  static const ExactVec3 &triple(const FormulaValue &value) { return std::get<ExactVec3>(value); }
  static bool isNumber(const FormulaValue &value) { return std::holds_alternative<Rational>(value); }

  static FormulaValue sum(const FormulaValue &a, const FormulaValue &b) {
    if (isNumber(a))
      return number(a) + number(b);
    return triple(a) + triple(b);
  }

  static FormulaValue times(const Rational &factor, const FormulaValue &value) {
    if (isNumber(value))
      return factor * number(value);
    return factor * triple(value);
  }

  /// At least one of them is a number.
  static FormulaValue product(const FormulaValue &a, const FormulaValue &b) {
    return isNumber(a) ? times(number(a), b) : times(number(b), a);
  }

  static Rational power(const Rational &base, const Rational &exponent) {
    Rational result = 1;
    for (Rational left = exponent; left > 0; left -= 1)
      result *= base;
    return result;
  }

  /// The zero vector has no other.
  static ExactVec3 shortest(const ExactVec3 &vector) {
    if (isZero(vector))
      return vector;
    const auto numbers = primitiveCoefficients(Plane<Rational>{vector, 0});
    return {numbers[0], numbers[1], numbers[2]};
  }

  static FormulaValue ofParts(const Formula &formula, const std::vector<FormulaValue> &values) {
    switch (formula.kind) {
    case FormulaKind::Component:
      return triple(values[0])[static_cast<int>(formula.number.words()->numerator)];
    case FormulaKind::Triple:
      return ExactVec3{number(values[0]), number(values[1]), number(values[2])};
    case FormulaKind::Sum:
      return sum(values[0], values[1]);
    case FormulaKind::Difference:
      return sum(values[0], times(-1, values[1]));
    case FormulaKind::Product:
      return product(values[0], values[1]);
    case FormulaKind::Quotient:
      return times(1 / number(values[1]), values[0]);
    case FormulaKind::Power:
      return power(number(values[0]), formula.parts[1].number);
    case FormulaKind::Dot:
      return isNumber(values[0]) || isNumber(values[1]) ? product(values[0], values[1])
                                                        : dot(triple(values[0]), triple(values[1]));
    case FormulaKind::Cross:
      return cross(triple(values[0]), triple(values[1]));
    case FormulaKind::Shortest:
      return shortest(triple(values[0]));
    default: // a sign
      return times(-1, values[0]);
    }
  }

  const ValueOfName &m_valueOfName;
};

} // namespace

std::variant<FormulaShape, FormulaFault> shapeOf(const Formula &formula, const ShapeOfName &shapeOfName) {
  return ShapeFinder(shapeOfName).find(formula);
}

std::variant<FormulaValue, FormulaFault> valueOf(const Formula &formula, const ValueOfName &valueOfName) {
  return Calculator(valueOfName).find(formula);
}

Formula formulaOf(const ExactVec3 &numbers) {
  Formula formula{FormulaKind::Triple};
  for (int axis = 0; axis < 3; ++axis)
    formula.parts.push_back({FormulaKind::Number, numbers[axis]});
  return formula;
}

} // namespace halfspace
