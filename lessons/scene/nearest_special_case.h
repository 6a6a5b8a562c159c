// How far a scene is from a special case of its constructions.
#pragma once

#include "geometry/surd.h"
#include "lessons/scene/edit.h"
#include "lessons/scene/evaluation.h"

#include <optional>
#include <set>
#include <string>

namespace halfspace {

/// A special case that a move of one free object leads to.
struct NearestSpecialCase {
  std::string sentence;               ///< "The ray would run parallel to the plane."
  Surd squareOfWay;                   ///< by which a coordinate moves to get there; above 0
  std::optional<ChangeObject> change; ///< nothing where a coordinate would have a root there
};

/// Of the special cases that the constructions of these entries name, the one that the least move of a
/// coordinate leads to, decided exactly. Nothing where there is none that a free object can be brought to.
[[nodiscard]] std::optional<NearestSpecialCase>
nearestSpecialCase(const Scene &scene, const Evaluation &evaluation, const std::set<std::string> &entries);

} // namespace halfspace
