// Where a dragged handle comes to rest: on the grid, or exactly on what matters nearby. No screen, no camera:
// how far apart two places are on the screen is asked of a function.
#pragma once

#include "lessons/figure/mark.h"
#include "lessons/object/flat.h"
#include "lessons/scene/hand/snap_targets.h"

#include <functional>

namespace halfspace {

/// What a drag knows when it asks where its handle comes to rest.
struct SnapRequest {
  const PlacedScene &scene;
  const Handle &handle; ///< as it is before this move
  const std::vector<SnapTarget> &targets;
  Place raw;     ///< where the pointer wants it
  Flat freedom;  ///< where it may go: a plane or a line through handle.at; for a sphere all of space
  Rational step; ///< of the grid; the finest suspends all that catches
  std::function<double(const Place &, const Place &)> pixelsApart;
  double catchPixels; ///< what is further away on the screen does not catch
};

/// Where a handle comes to rest.
struct SnappedPlace {
  ExactVec3 at;
  std::string caughtBy; ///< in plain words: “vertex P₁”, “parallel to E”; empty for the grid alone
};

/// The exact place for a dragged handle.
///
/// On the grid the value `at − base` is a multiple of the step in every coordinate that can move; the others
/// stay. Along a slanted line it is the coordinate that changes most, and in a slanted plane two of the three
/// where no place of the grid is near. A bound object rests where its freedoms
/// are round (Binding::onGrid), and never off its host.
///
/// A target (a vertex, an edge, a plane, a curved surface; for a direction: parallel, through a vertex or an
/// edge, along an axis) catches within `catchPixels`: points before lines before planes, then the nearest.
/// The handle slides on it from grid place to grid place, and where there is none nearby to a place with
/// short fractions; those of more than `longestSnapDenominator` digits are never taken, and a curve without
/// any catches nowhere. A grid place that stands alone and is nearer to the pointer goes before places with
/// fractions.
[[nodiscard]] SnappedPlace snap(const SnapRequest &request);

inline constexpr std::size_t longestSnapDenominator = 6;
/// The step of a drag while snapping is suspended. The pointer's place is taken to this fineness before exact
/// work begins: far below a pixel, and short.
inline const Rational finestStep(1, 1000);

} // namespace halfspace
