// What can be grabbed in the picture, and what a grabbed handle does to its object. No screen, no camera.
#pragma once

#include "lessons/object/object.h"

#include <memory>

namespace halfspace {

/// A handle of an object.
struct Handle {
  enum class Motion {
    Coordinate,  ///< moves one coordinate: a position, or the tip of a direction
    AlongNormal, ///< moves all positions along an axis
    Whole,       ///< moves all positions of the object together
    Length,      ///< gives a length the distance from the base along the axis
    OnHost,      ///< moves a bound object on what it lies on
  };
  std::string id;     ///< `E.n`, `Q`, `E.offset`, `T.whole`
  std::string object; ///< the entry's name
  Motion motion = Motion::Coordinate;
  std::size_t coordinate = 0; ///< for Coordinate and Length: the index in coordinatesOf(object)
  ExactVec3 at{};             ///< where it is
  ExactVec3 base{};   ///< at − base is what is snapped: 0 for a position, the arrow's start for a direction
  ExactVec3 axis{};   ///< the direction in which alone it moves; 0 where it is free
  ExactVec3 normal{}; ///< perpendicular to the plane in which alone it moves; 0 where it is free
  ExactVec3 middle{}; ///< of the positions, for Whole
  std::optional<ExactVec3> center{};    ///< of the sphere on which alone it moves
  std::shared_ptr<const Object> host{}; ///< what a bound object lies on

  /// Whether it moves along its axis alone.
  [[nodiscard]] bool hasAxis() const { return !isZero(axis); }
};

/// The object after the handle was moved to a place.
[[nodiscard]] Object movedTo(const Object &object, const Handle &handle, const ExactVec3 &place);

/// Where an object lies that is bound to a host; nothing where the host has no places.
[[nodiscard]] std::optional<ExactVec3> placeOn(const Object &bound, const Object &host);
/// The bound object after its handle was moved to the step of the grid that is nearest to a place.
[[nodiscard]] Object movedToGrid(const Object &bound, const Handle &handle, const ExactVec3 &place,
                                 const Rational &step);

} // namespace halfspace
