// The plain picture of an object that no construction draws.
#pragma once

#include "lessons/figure/figure.h"
#include "lessons/object/object.h"

namespace halfspace {

/// The marks of an object. Their ids are `object:E`, and for its coordinates `object:E.n`: a construction's
/// marks, named after its own roles, never have a colon.
[[nodiscard]] std::vector<Mark> marksOf(const std::string &name, const Object &object);

} // namespace halfspace
