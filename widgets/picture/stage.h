// The part of space that a picture is about, and its own measure.
#pragma once

#include "lessons/figure/figure.h"
#include "lessons/scene/placed_scene.h"

namespace halfspace {

/// Where a picture's origin stands in the scene, and how long its unit is. Whatever the size of a scene's
/// numbers, on its stage the objects lie within `stageReach` of the origin: there thicknesses, margins, the
/// ground and the camera are at home, and single-precision numbers are fine enough.
///
/// The stage of a scene of usual size is the scene's own space: unit 1, origin at the origin.
struct Stage {
  ExactVec3 middle{0}; ///< the scene's place where the picture has its origin
  int exponent = 0;    ///< the unit is 10 to this power, in scene units

  /// Whether the scene's axes are on the stage; then its origin is the picture's.
  [[nodiscard]] bool hasAxes() const { return isZero(middle); }
  /// Whether the scene's ground, z = 0, is on the stage; then it is the picture's.
  [[nodiscard]] bool hasGround() const { return middle.z == 0; }
  /// The unit, exactly.
  [[nodiscard]] Rational unit() const;

  bool operator==(const Stage &) const = default;
};

/// The stage for the positions of a scene's objects, bound ones where they are (for its directions, where all
/// positions are the origin). The origin belongs to it unless the objects stand together far away from it.
[[nodiscard]] Stage stageOf(const Scene &scene, const std::vector<PlacedObject> &bound);
[[nodiscard]] inline Stage stageOf(const PlacedScene &placed) { return stageOf(placed.scene, placed.bound); }

/// The power of ten in which a length is neither long nor short: 0 for usual ones, else one that leaves it 2
/// to 20 units long, or 5 to 50.
[[nodiscard]] int suitingExponent(double across);

/// The objects lie within so many units of a stage's origin, in each coordinate.
inline constexpr double stageReach = 200;
/// Nothing is drawn beyond so many units from a stage's origin, in each coordinate.
inline constexpr double drawnReach = 1000;

/// Coordinates in units of the stage, exactly; and back.
[[nodiscard]] ExactVec3 toStage(const ExactVec3 &value, CoordinateRole role, const Stage &stage);
[[nodiscard]] ExactVec3 fromStage(const ExactVec3 &value, CoordinateRole role, const Stage &stage);
[[nodiscard]] PlacedScene toStage(PlacedScene scene, const Stage &stage);
[[nodiscard]] Object toStage(Object object, const Stage &stage);
[[nodiscard]] Object fromStage(Object object, const Stage &stage);

/// A figure in units of the stage, all its places finite and within drawnReach: lines are cut off there, an
/// arrow whose tip lies beyond is a line up to there, and what lies beyond is left out. On a stage that is
/// not the scene's own space, free arrows are drawn neither too short nor too long to be seen. (What is drawn
/// around a place, as a patch or the end of a ray behind what it meets, may reach some units farther.)
[[nodiscard]] Figure toStage(const Figure &figure, const Stage &stage);

} // namespace halfspace
