// Objects whose corners can be added and taken away: polygons, prisms.
#pragma once

#include "lessons/object/object.h"

namespace halfspace {

/// The coordinates that are corners, in their order; none where their number is fixed.
[[nodiscard]] std::vector<std::size_t> cornersOf(const Object &object);

/// Whether a coordinate is a corner that another can follow, or that can be taken away.
[[nodiscard]] bool canAddCornerAfter(const Object &object, std::size_t corner);
[[nodiscard]] bool canRemoveCorner(const Object &object, std::size_t corner);

/// With one more corner, in the middle of the edge from a corner to the next. Requires that it can be added.
[[nodiscard]] Object withCornerAfter(Object object, std::size_t corner);
/// Without a corner; those behind it move up. Requires that it can be taken away.
[[nodiscard]] Object withoutCorner(Object object, std::size_t corner);

} // namespace halfspace
