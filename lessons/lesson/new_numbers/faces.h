// New numbers for polygons, screens and solids, with a face of each for others to aim at.
#pragma once

#include "lessons/lesson/new_numbers/net.h"

#include <optional>
#include <string_view>

namespace halfspace {

/// Whether objects of a kind are drawn with a face.
[[nodiscard]] bool hasFace(std::string_view kind);

/// Gives an object whose kind has a face other numbers, with as many corners or pixels as before, and returns
/// that face. Of other kinds: leaves the object as it is, without a roll, and returns nothing.
[[nodiscard]] std::optional<Net> drawFace(Object &object, Dice &dice);

} // namespace halfspace
