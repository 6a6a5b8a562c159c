// How far a scene is from the special cases of its constructions.
#pragma once

#include "geometry/surd.h"
#include "lessons/scene/edit.h"
#include "lessons/scene/evaluation.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace halfspace {

/// A special case that a move of one free object leads to.
struct NearSpecialCase {
  std::string entry;                  ///< the construction that names it
  Conditions when;                    ///< what holds of that there, by its own names
  std::string sentence;               ///< "The ray would run parallel to the plane."
  Surd squareOfWay;                   ///< by which a coordinate moves to get there; above 0
  std::optional<ChangeObject> change; ///< the least; nothing where a coordinate would have a root there
};

/// The special cases that the constructions of these entries name and that a free object can be brought to,
/// the one that the least move of a coordinate leads to first, decided exactly. Of several with the same
/// sentence only the nearest.
[[nodiscard]] std::vector<NearSpecialCase> specialCasesNear(const Scene &scene, const Evaluation &evaluation,
                                                            const std::set<std::string> &entries);

} // namespace halfspace
