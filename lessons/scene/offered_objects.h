// What goes by a name in what a scene comes to.
#pragma once

#include "lessons/scene/evaluation.h"

namespace halfspace {

/// The object that goes by an id: `Q`, or `distance.F` for what a construction makes, even where it is not
/// there in the present case; null where there is none.
[[nodiscard]] const OfferedObject *findOffered(const Evaluation &evaluation, std::string_view id);

/// The name by which a coordinate was put into its object, where that follows others: A for T.P0 of
/// T = triangle(A, B, C), and for what follows that in turn; else the name itself.
[[nodiscard]] std::string sourceOf(const Scene &scene, std::string name);

/// A coordinate as it is now; a single number stands in x.
struct CoordinateValue {
  CoordinateRole role;
  ExactVec3 value;
};
/// The coordinate that a name stands for in a formula: of `Q`, `T.P0`, `hit.L.r`. Nothing for what is no
/// coordinate, and for what is not there now.
[[nodiscard]] std::optional<CoordinateValue> coordinateValue(const Evaluation &evaluation,
                                                             std::string_view name);
/// … where it is a place.
[[nodiscard]] std::optional<ExactVec3> placeNamed(const Evaluation &evaluation, std::string_view name);

} // namespace halfspace
