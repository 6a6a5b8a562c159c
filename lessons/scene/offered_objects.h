// What goes by a name in what a scene comes to.
#pragma once

#include "lessons/scene/evaluation.h"

namespace halfspace {

/// The object that goes by an id: `Q`, or `distance.F` for what a construction makes, even where it is not
/// there in the present case; null where there is none.
[[nodiscard]] const OfferedObject *findOffered(const Evaluation &evaluation, std::string_view id);

/// The place that a name stands for in a formula: a point, `T.P0`. Nothing for what is no place, and for what
/// is not there now.
[[nodiscard]] std::optional<ExactVec3> placeNamed(const Evaluation &evaluation, std::string_view name);

} // namespace halfspace
