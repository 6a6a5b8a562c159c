// Objects whose numbers leave nothing of what their kind is.
#pragma once

#include "lessons/object/given.h"

#include <string>

namespace halfspace {

/// What is wrong with an object that is none of its kind: a plane whose normal is zero, a line or a ray
/// without a direction, a segment between one point and itself, a triangle on one line. Empty for all others,
/// and for those of further kinds.
[[nodiscard]] std::string whyDegenerate(const Given<Object> &given);

} // namespace halfspace
