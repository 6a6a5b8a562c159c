// Constructions that are typed as calls.
#pragma once

#include "lessons/scene/scene.h"
#include "lessons/typed/argument.h"
#include "lessons/typed/scene_names.h"

namespace halfspace {

struct Construction;

/// What a construction looks at, as a list: “a plane, a point”.
[[nodiscard]] std::string objectsWantedBy(const Construction &construction);

/// The use of the first construction of this id or word into whose roles the arguments fit: in any order, as
/// far as kinds tell it. Or what is wrong with them; `at` is where the word stands.
[[nodiscard]] std::variant<ConstructionUse, TypedFault> useOf(const std::string &word, std::size_t at,
                                                              const std::vector<Argument> &arguments,
                                                              const SceneNames &names);

/// Why an argument is not the name of an object of a kind.
[[nodiscard]] TypedFault misfit(const Argument &argument, std::string_view needed, const SceneNames &names);

} // namespace halfspace
