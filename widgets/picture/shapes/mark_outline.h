// What a mark consists of, as plain lines and faces: for meshes, for picking, and for labels that keep out of
// the way.
#pragma once

#include "lessons/figure/mark.h"

namespace halfspace {

/// The bare geometry of a mark.
struct MarkOutline {
  enum class Kind { Point, Line, Face, Body };
  Kind kind = Kind::Line;
  std::vector<Place> path; ///< one point; an open path; the corners around a face; or of the box around a
                           ///< body. Empty where nothing can be drawn.
};

/// The outline of a mark; `size` is what arcs and right-angle marks of the scene measure, in scene units.
/// Marks with coordinates that are not finite have an empty one.
[[nodiscard]] MarkOutline outlineOf(const Mark &mark, double size);

} // namespace halfspace
