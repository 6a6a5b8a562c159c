// The box that three vectors span, as constructions draw a determinant.
#pragma once

#include "lessons/figure/figure.h"
#include "lessons/object/object.h"

#include <array>

namespace halfspace {

/// Adds the parallelogram of two vectors from a point; nothing where it has no area.
void addParallelogram(Figure &figure, const MarkBase &base, const ExactVec3 &from, const ExactVec3 &first,
                      const ExactVec3 &second);

/// Adds those of the box's six faces that have an area, as parts of the mark.
void addSpannedBox(Figure &figure, const MarkBase &base, const ExactVec3 &corner,
                   const std::array<ExactVec3, 3> &sides);

} // namespace halfspace
