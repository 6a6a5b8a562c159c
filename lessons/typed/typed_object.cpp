#include "lessons/typed/typed_object.h"

#include "lessons/object/kind.h"
#include "lessons/object/kinds/number.h"
#include "lessons/words.h"

#include <algorithm>

namespace halfspace {
namespace {

std::optional<FormulaShape> shapeNamed(std::string_view name, const SceneNames &names) {
  const auto value = names.value(std::string(name));
  if (!value)
    return {};
  return numbersIn(value->role) == 1 ? FormulaShape::Number : FormulaShape::Triple;
}

TypedFault unknown(const Formula &name, const SceneNames &names) {
  if (const std::string_view kind = names.kindOf(name.name); !kind.empty())
    return {words("“{name}” is {kind}: a formula is about numbers, points and vectors.",
                  {{"name", name.name}, {"kind", nounOf(kind)}}),
            name.at, name.name.size()};
  return {words("There is no “{name}”.", {{"name", name.name}}), name.at, name.name.size()};
}

/// Gives the names in a formula their ids.
std::optional<TypedFault> nameAll(Formula &formula, const SceneNames &names) {
  if (formula.kind == FormulaKind::Name) {
    const auto value = names.value(formula.name);
    if (!value)
      return unknown(formula, names);
    formula.name = value->id;
  }
  for (Formula &part : formula.parts)
    if (auto fault = nameAll(part, names))
      return fault;
  return {};
}

/// Makes a formula one of its coordinate; or says what does not fit.
std::optional<TypedFault> fit(Argument &argument, CoordinateRole role, const SceneNames &names) {
  auto named = namedIn(std::move(argument.formula), names);
  if (auto *fault = std::get_if<TypedFault>(&named))
    return std::move(*fault);
  argument.formula = std::get<Formula>(std::move(named));
  const auto shape = shapeIn(argument.formula, names);
  if (const auto *fault = std::get_if<TypedFault>(&shape))
    return *fault;
  const bool isNumber = std::get<FormulaShape>(shape) == FormulaShape::Number;
  if (isNumber == (numbersIn(role) == 1))
    return {};
  return faultAt(argument, isNumber
                               ? words("Here three numbers are needed, as (1, 2, 3), a point or a vector.")
                               : words("Here a number is needed, not a point or a vector."));
}

} // namespace

std::variant<Formula, TypedFault> namedIn(Formula formula, const SceneNames &names) {
  if (auto fault = nameAll(formula, names))
    return std::move(*fault);
  return formula;
}

std::variant<FormulaShape, TypedFault> shapeIn(const Formula &formula, const SceneNames &names) {
  const auto shape = shapeOf(formula, [&](std::string_view name) { return shapeNamed(name, names); });
  if (const auto *fault = std::get_if<FormulaFault>(&shape))
    return TypedFault{fault->sentence, fault->at, 1};
  return std::get<FormulaShape>(shape);
}

bool hasNames(const Formula &formula) {
  bool has = false;
  forEachName(formula, [&](const std::string &) { has = true; });
  return has;
}

std::variant<ExactVec3, TypedFault> constantOf(const Argument &argument) {
  const auto value =
      valueOf(argument.formula, [](std::string_view) { return std::optional<FormulaValue>(); });
  if (const auto *fault = std::get_if<FormulaFault>(&value))
    return faultAt(argument, fault->sentence);
  const auto &found = std::get<FormulaValue>(value);
  const auto *number = std::get_if<Rational>(&found);
  return number ? ExactVec3(*number, 0, 0) : std::get<ExactVec3>(found);
}

std::variant<Object, DerivedObject, TypedFault> objectOf(const Kind &kind, std::vector<Argument> coordinates,
                                                         const SceneNames &names) {
  DerivedObject derived{&kind, {}};
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    if (auto fault = fit(coordinates[i], kind.coordinates[i].role, names))
      return std::move(*fault);
    derived.coordinates.push_back(coordinates[i].formula);
  }
  if (std::any_of(derived.coordinates.begin(), derived.coordinates.end(), hasNames)) {
    if (kind.binding)
      return faultAt(coordinates.front(),
                     words("Where {kind} lies is told by numbers alone.", {{"kind", kind.noun()}}));
    return derived;
  }
  Object object(kind);
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    if (i == object.size())
      object.addVertex();
    auto value = constantOf(coordinates[i]);
    if (auto *fault = std::get_if<TypedFault>(&value))
      return std::move(*fault);
    object[i] = std::get<ExactVec3>(value);
  }
  return object;
}

} // namespace halfspace
