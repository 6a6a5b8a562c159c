#include "lessons/typed/equation.h"

#include "geometry/exact_root.h"
#include "lessons/words.h"

#include <algorithm>
#include <array>

namespace halfspace {
namespace {

constexpr std::array<std::string_view, 3> unknowns{"x", "y", "z"};

/// The highest power of the unknowns in a formula; nothing where it is none of them.
std::optional<int> degreeOf(const Formula &formula) {
  std::vector<int> degrees;
  for (const Formula &part : formula.parts) {
    const auto degree = degreeOf(part);
    if (!degree)
      return {};
    degrees.push_back(*degree);
  }
  switch (formula.kind) {
  case FormulaKind::Number:
    return 0;
  case FormulaKind::Name:
    return 1;
  case FormulaKind::Sum:
  case FormulaKind::Difference:
    return std::max(degrees[0], degrees[1]);
  case FormulaKind::Negative:
    return degrees[0];
  case FormulaKind::Product:
  case FormulaKind::Dot:
    return degrees[0] + degrees[1];
  case FormulaKind::Quotient:
    return degrees[1] == 0 ? std::optional(degrees[0]) : std::nullopt;
  case FormulaKind::Power:
    return degrees[0] * static_cast<int>(formula.parts[1].number.words()->numerator);
  default:
    return {};
  }
}

/// The first name in an equation that is not x, y or z, with what is said of it.
std::optional<FormulaFault> strangerIn(const Formula &formula, const std::string &sentence) {
  std::optional<FormulaFault> fault;
  const std::function<void(const Formula &)> look = [&](const Formula &part) {
    const bool isUnknown = std::find(unknowns.begin(), unknowns.end(), part.name) != unknowns.end();
    if (!fault && part.kind == FormulaKind::Name && !isUnknown)
      fault = FormulaFault{sentence, part.at};
    for (const Formula &each : part.parts)
      look(each);
  };
  look(formula);
  return fault;
}

std::optional<FormulaFault> faultIn(const Formula &formula) {
  std::optional<FormulaFault> fault =
      strangerIn(formula, words("The equation of a plane has x, y, z and numbers: write plane(P, n) for one "
                                "that follows others."));
  if (!fault && degreeOf(formula).value_or(2) > 1)
    fault = FormulaFault{words("A plane has an equation as x + 2y + 2z = 27: no products of x, y and z."),
                         formula.at};
  return fault;
}

/// At x, y, z; nothing where it would be divided by zero.
std::optional<Rational> valueAt(const Formula &formula, const ExactVec3 &place) {
  const auto value = valueOf(formula, [&](std::string_view name) -> std::optional<FormulaValue> {
    for (std::size_t axis = 0; axis < unknowns.size(); ++axis)
      if (name == unknowns.at(axis))
        return place[static_cast<int>(axis)];
    return {};
  });
  const auto *found = std::get_if<FormulaValue>(&value);
  return found ? std::optional(std::get<Rational>(*found)) : std::nullopt;
}

/// A point of n · x = d on an axis.
ExactVec3 pointOnAxis(const ExactVec3 &normal, const Rational &d) {
  std::optional<int> chosen;
  for (int axis = 0; axis < 3; ++axis) {
    if (normal[axis] == 0)
      continue;
    if (!chosen || (Rational(d / normal[axis]).isInteger() && !Rational(d / normal[*chosen]).isInteger()))
      chosen = axis;
  }
  ExactVec3 point(0);
  point[*chosen] = d / normal[*chosen];
  return point;
}

/// So far from the whole numbers nearest to the foot of the origin others are tried.
constexpr int farthestTried = 2;

/// A point of n · x = d with whole numbers as near to the origin as one is found, so that the plane is seen
/// where the axes are; else one on an axis.
ExactVec3 pointOn(const ExactVec3 &normal, const Rational &d) {
  const ExactVec3 foot = normal * Rational(d / dot(normal, normal));
  std::optional<ExactVec3> nearest;
  const auto tryPoint = [&](ExactVec3 point, int solved) {
    point[solved] = 0;
    point[solved] = (d - dot(normal, point)) / normal[solved];
    if (point[solved].isInteger() && (!nearest || dot(point, point) < dot(*nearest, *nearest)))
      nearest = point;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (int i = -farthestTried; i <= farthestTried && normal[axis] != 0; ++i)
      for (int j = -farthestTried; j <= farthestTried; ++j) {
        ExactVec3 point(0);
        point[(axis + 1) % 3] = roundToMultiple(foot[(axis + 1) % 3], 1) + i;
        point[(axis + 2) % 3] = roundToMultiple(foot[(axis + 2) % 3], 1) + j;
        tryPoint(point, axis);
      }
  return nearest.value_or(pointOnAxis(normal, d));
}

/// A quadratic formula: a·x² for each axis, the factor of x for each axis, and what stands alone.
struct Quadratic {
  ExactVec3 squares{};
  ExactVec3 factors{};
  Rational constant;
  bool hasMixed = false; ///< a product of two different unknowns
};

ExactVec3 unitOfAxis(int axis) {
  ExactVec3 unit(0);
  unit[axis] = 1;
  return unit;
}

/// By its values in seven places, and in three more that tell of mixed products. Nothing where it would be
/// divided by zero.
std::optional<Quadratic> quadraticOf(const Formula &formula) {
  const auto constant = valueAt(formula, ExactVec3(0));
  if (!constant)
    return {};
  Quadratic found{{}, {}, *constant};
  for (int axis = 0; axis < 3; ++axis) {
    const Rational ahead = *valueAt(formula, unitOfAxis(axis));
    const Rational behind = *valueAt(formula, -unitOfAxis(axis));
    found.squares[axis] = (ahead + behind) / 2 - *constant;
    found.factors[axis] = (ahead - behind) / 2;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const int next = (axis + 1) % 3;
    const Rational both = *valueAt(formula, unitOfAxis(axis) + unitOfAxis(next));
    const Rational unmixed =
        found.squares[axis] + found.squares[next] + found.factors[axis] + found.factors[next] + *constant;
    found.hasMixed = found.hasMixed || both != unmixed;
  }
  return found;
}

bool isNamed(const Formula &formula, const std::function<bool(const std::string &)> &isMeant) {
  return formula.kind == FormulaKind::Name && isMeant(formula.name);
}

bool hasName(const Formula &formula, const std::string &name) {
  bool has = false;
  forEachName(formula, [&](const std::string &each) { has = has || each == name; });
  return has;
}

} // namespace

std::variant<PlaneObject, FormulaFault> planeOf(const Formula &left, const Formula &right) {
  const Formula zero{FormulaKind::Difference, {}, {}, {left, right}, left.at};
  if (auto fault = faultIn(zero))
    return *fault;
  const auto constant = valueAt(zero, ExactVec3(0));
  if (!constant)
    return FormulaFault{words("This would be divided by zero."), left.at};
  ExactVec3 normal(0);
  for (int axis = 0; axis < 3; ++axis) {
    normal[axis] = *valueAt(zero, unitOfAxis(axis)) - *constant;
  }
  if (isZero(normal))
    return FormulaFault{words("No x, y or z is left in this equation: it is no plane."), left.at};
  return PlaneObject{pointOn(normal, -*constant), normal};
}

bool isQuadratic(const Formula &left, const Formula &right) {
  return std::max(degreeOf(left).value_or(3), degreeOf(right).value_or(3)) == 2;
}

std::variant<SphereObject, FormulaFault> sphereOf(const Formula &left, const Formula &right) {
  const Formula zero{FormulaKind::Difference, {}, {}, {left, right}, left.at};
  if (auto fault =
          strangerIn(zero, words("The equation of a sphere has x, y, z and numbers: write sphere(M, k) "
                                 "for one that follows others.")))
    return *fault;
  const auto found = quadraticOf(zero);
  if (!found)
    return FormulaFault{words("This would be divided by zero."), left.at};
  if (isZero(found->squares)) // x y = 3 is no nearer to a sphere than to a plane
    return *faultIn(zero);
  const Rational &square = found->squares.x;
  if (square == 0 || found->squares.y != square || found->squares.z != square || found->hasMixed)
    return FormulaFault{
        words("A sphere has an equation as (x - 1)^2 + (y - 2)^2 + z^2 = 9, with all three squares alike."),
        left.at};
  const ExactVec3 center = found->factors * Rational(Rational(-1) / (2 * square));
  const Rational radiusSquared = dot(center, center) - found->constant / square;
  if (radiusSquared < 0)
    return FormulaFault{words("No point has these coordinates: the square of the radius would be {square}.",
                              {{"square", toText(radiusSquared)}}),
                        left.at};
  const auto radius = exactRoot(radiusSquared);
  if (!radius)
    return FormulaFault{
        words("Its radius would be √({square}), which is not a fraction: here a radius must be one.",
              {{"square", toText(radiusSquared)}}),
        left.at};
  return SphereObject{center, *radius};
}

std::optional<PlaneEquation> equationFor(const PlaneObject &plane) {
  if (isZero(plane.normal))
    return {};
  std::optional<Formula> left;
  for (std::size_t axis = 0; axis < unknowns.size(); ++axis) {
    const Rational &factor = plane.normal[static_cast<int>(axis)];
    if (factor == 0)
      continue;
    const bool isSubtracted = left && factor < 0;
    const Rational size = isSubtracted ? Rational(-factor) : factor;
    const Formula unknown{FormulaKind::Name, {}, std::string(unknowns.at(axis))};
    Formula term =
        size == 1 ? unknown : Formula{FormulaKind::Product, {}, {}, {{FormulaKind::Number, size}, unknown}};
    if (left)
      term = {isSubtracted ? FormulaKind::Difference : FormulaKind::Sum, {}, {}, {*left, std::move(term)}};
    left = std::move(term);
  }
  PlaneEquation equation{*left, {FormulaKind::Number, dot(plane.normal, plane.point)}};
  const auto again = planeOf(equation.left, equation.right);
  const auto *read = std::get_if<PlaneObject>(&again);
  return read && *read == plane ? std::optional(std::move(equation)) : std::nullopt;
}

std::optional<ParametricLine> parametricOf(const Formula &formula,
                                           const std::function<bool(const std::string &)> &isUnknown) {
  if (formula.kind != FormulaKind::Sum && formula.kind != FormulaKind::Difference)
    return {};
  const Formula &product = formula.parts[1];
  if (product.kind != FormulaKind::Product && product.kind != FormulaKind::Dot)
    return {};
  for (const std::size_t place : {0U, 1U}) {
    const Formula &name = product.parts[place];
    Formula direction = product.parts[1 - place];
    if (!isNamed(name, isUnknown) || isPlainNumber(direction) || isPlainNumber(formula.parts[0]) ||
        hasName(direction, name.name) || hasName(formula.parts[0], name.name))
      continue;
    if (formula.kind == FormulaKind::Difference)
      direction = {FormulaKind::Negative, {}, {}, {direction}, direction.at};
    return ParametricLine{formula.parts[0], std::move(direction), name.name};
  }
  return {};
}

} // namespace halfspace
