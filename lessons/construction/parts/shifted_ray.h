// Rays moved sideways.
#pragma once

#include "lessons/object/kinds/ray.h"

#include <optional>

namespace halfspace {

/// The shortest way by which the ray is to be moved for its line to meet the line of a segment, where it then
/// meets it between the ends; nothing where it would not, or where the two are parallel.
[[nodiscard]] std::optional<ExactVec3> shiftOntoSegment(const RayObject &ray, const ExactVec3 &from,
                                                        const ExactVec3 &to);

} // namespace halfspace
