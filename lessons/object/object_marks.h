// The picture of an object by itself.
#pragma once

#include "lessons/figure/figure.h"
#include "lessons/object/given.h"

namespace halfspace {

/// The marks of an object. Their ids are those of the object and of its coordinates: `E`, `E.n`. What has no
/// length or no area is left out.
[[nodiscard]] std::vector<Mark> marksOf(const Given<Object> &given);

} // namespace halfspace
