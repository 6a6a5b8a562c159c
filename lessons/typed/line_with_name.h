// A name for a typed line that has none.
#pragma once

#include "lessons/scene/scene.h"

namespace halfspace {

/// A line with a name before what somebody has typed.
struct LineWithName {
  std::string line;
  std::size_t added = 0; ///< the bytes that stand before what was typed
};

/// A line under a name that is free in the scene, and usual for what it says: `T = triangle(A, B, C)` for
/// `triangle(A, B, C)`, `E: x + 2y = 3` for `x + 2y = 3`. Three numbers alone, `1, 2, 3`, are a point, as
/// tables of coordinates have them, and `P(1|2|3)` is the point P, as some schools write it. A line that has
/// a name is as it is; one that cannot be read under any has one all the same, so that what is wrong with the
/// rest can be told.
[[nodiscard]] LineWithName withName(std::string_view line, const Scene &above, char decimalMark = '.');

/// A line of an entry that has a name already: under that one, unless the line says another.
[[nodiscard]] LineWithName withName(std::string_view line, const std::string &name);

} // namespace halfspace
