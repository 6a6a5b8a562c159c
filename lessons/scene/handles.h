// What can be grabbed in the picture, and what a grabbed handle does to its object. Derived from the objects'
// descriptions; no screen, no camera.
#pragma once

#include "lessons/scene/scene.h"

#include <glm/vec3.hpp>

namespace halfspace {

/// A handle of an object.
struct Handle {
  enum class Motion {
    Coordinate,  ///< moves one coordinate: a position, or the tip of a direction
    AlongNormal, ///< moves a plane's point along its normal
    Whole,       ///< moves all positions of the object together
  };
  std::string id;     ///< `E.n`, `Q`, `E.offset`, `T.whole`
  std::string object; ///< the entry's name
  Motion motion = Motion::Coordinate;
  std::size_t coordinate = 0; ///< for Motion::Coordinate: the index in coordinatesOf(object)
  ExactVec3 at{};             ///< where it is
  ExactVec3 base{}; ///< at − base is what is snapped: 0 for a position, the arrow's start for a direction
  ExactVec3 axis{}; ///< for AlongNormal: the direction in which alone it moves
};

/// The handles of all objects of a scene.
[[nodiscard]] std::vector<Handle> handlesOf(const Scene &scene);

/// The object after the handle was moved to a place.
[[nodiscard]] Object movedTo(const Object &object, const Handle &handle, const ExactVec3 &place);

} // namespace halfspace
