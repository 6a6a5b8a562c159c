// What the names in the formulas of a scene stand for.
#pragma once

#include "lessons/object/object.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace halfspace {

/// A coordinate of an object, free or not.
struct NamedCoordinate {
  std::string object; ///< its id
  std::size_t index = 0;
  CoordinateRole role{};
};

/// What a coordinate of an object that follows others is called among values: `at` of a point; empty for the
/// bounds of a number, which it has none of.
[[nodiscard]] std::string valueNameOf(const Kind &kind, std::size_t index);

/// The kind of the object of an id; null where there is none.
using KindOfId = std::function<const Kind *(std::string_view id)>;

/// The coordinate that a name means in a formula: `E.n`, `hit.L.r`; of an object that goes by one coordinate
/// that one, a point's place, a vector, a number's value. Nothing where there is none.
[[nodiscard]] std::optional<NamedCoordinate> coordinateNamed(std::string_view name, const KindOfId &kindOfId);

} // namespace halfspace
