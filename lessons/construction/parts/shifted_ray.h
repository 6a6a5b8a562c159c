// Rays moved sideways.
#pragma once

#include "lessons/construction/special_case.h"
#include "lessons/object/kinds/ray.h"

#include <string>
#include <utility>
#include <vector>

namespace halfspace {

/// Adds the ray moved sideways until its line meets a point, or a segment between its ends; nothing where it
/// does already, or never would. `when` and `sentence` say what holds then.
void addRayThrough(const RayObject &ray, const ExactVec3 &point, Conditions when, std::string sentence,
                   std::vector<SpecialCase> &all);
void addRayThrough(const RayObject &ray, const std::pair<ExactVec3, ExactVec3> &segment, Conditions when,
                   std::string sentence, std::vector<SpecialCase> &all);

} // namespace halfspace
