// What constructions of two planes share.
#pragma once

#include "lessons/construction/outcome.h"
#include "lessons/object/kinds/plane.h"

#include <optional>

namespace halfspace {

/// The case of two planes, one or both of which have no normal.
[[nodiscard]] CaseWords zeroNormalsWords(const PlaneTerms &first, const PlaneTerms &second);

/// A plane that was turned about its point to be parallel to another.
struct TurnedPlane {
  PlaneObject plane;
  bool isTheOther; ///< whether it is the same plane then
};
/// Nothing where it is perpendicular to the other: then no turn is the smallest. Requires normals ≠ 0.
[[nodiscard]] std::optional<TurnedPlane> turnedParallel(const PlaneObject &plane, const PlaneObject &other);

/// A plane that was slid along its normal until it is the same as another, which is parallel to it.
[[nodiscard]] PlaneObject slidInto(const PlaneObject &plane, const PlaneObject &parallel);

} // namespace halfspace
