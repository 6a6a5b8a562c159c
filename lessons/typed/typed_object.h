// Objects out of typed formulas.
#pragma once

#include "lessons/scene/scene.h"
#include "lessons/typed/argument.h"
#include "lessons/typed/scene_names.h"

namespace halfspace {

/// A formula in which what is named has its id; or what does not fit in it.
[[nodiscard]] std::variant<Formula, TypedFault> namedIn(Formula formula, const SceneNames &names);

/// Whether a formula comes to a number or to three. All its names are ids of the scene.
[[nodiscard]] std::variant<FormulaShape, TypedFault> shapeIn(const Formula &formula, const SceneNames &names);

/// Whether there are names in a formula.
[[nodiscard]] bool hasNames(const Formula &formula);

/// What a formula without names comes to, a number as x; or why it comes to nothing.
[[nodiscard]] std::variant<ExactVec3, TypedFault> constantOf(const Argument &argument);

/// An object of a kind by its coordinates in their order: one that follows others where there are names in
/// them. The kind has no shape.
[[nodiscard]] std::variant<Object, DerivedObject, TypedFault>
objectOf(const Kind &kind, std::vector<Argument> coordinates, const SceneNames &names);

} // namespace halfspace
