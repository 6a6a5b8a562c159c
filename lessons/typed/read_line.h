// A typed line as an entry of a scene: Q = (11, 15, 8), E: x + 2y + 2z = 27, d = distance(E, Q).
#pragma once

#include "lessons/scene/scene.h"
#include "lessons/typed/typed_fault.h"

namespace halfspace {

/// Reads a line that is to be the next entry of a scene.
///
/// - `Q = (1, 2, 3)` is a point, `v = (1, 2, 3)` in small letters a vector, `k = 3/2` a number, with its
/// bounds and
///   step `k = 3/2, 0 <= k <= 5, step 1/2`.
/// - `E: x + 2y + 2z = 27` is a plane, `S: (x - 1)^2 + y^2 + z^2 = 9` a sphere; `g = A + t(1, 2, 3)` a line,
/// a ray where t >= 0 follows or the name begins
///   with r, a segment where 0 <= t <= 1 does.
/// - `g = line(A, B)` leads from one point to another, and so do a ray and a vector.
/// - `E = plane(P0, n)`, likewise for each kind with its coordinates in their order; `plane(A, B, C)` goes
/// through
///   points. `P = point-on-line(g, 2)`: what an object lies on, then its freedoms.
/// - `d = distance(E, Q)`: a construction by its id or its word, which takes what it looks at in any order,
/// as far
///   as kinds tell it.
/// - Its look may follow (`lookWords`): `Q = (1, 2, 3), green, locked`.
///
/// Coordinates are formulas: an object with names in one follows these. The fault is in the line's bytes.
[[nodiscard]] std::variant<Entry, TypedFault> readLine(std::string_view line, const Scene &above,
                                                       char decimalMark = '.');

} // namespace halfspace
