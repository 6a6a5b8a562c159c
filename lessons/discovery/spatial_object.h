// Objects as things in space that can lie on each other, be parallel, be equally long.
#pragma once

#include "lessons/object/object.h"

namespace halfspace {

/// What an object is in space.
enum class Form : std::uint8_t { Point, Vector, Line, Ray, Segment, Plane, Face, Sphere, Number };

struct SpatialObject {
  Form form;
  ExactVec3 at{};  ///< a place of it, the centre of a sphere; of a vector, which lies nowhere, the origin
  ExactVec3 way{}; ///< of what has one its direction ≠ 0, of a segment to its end; of a plane a normal ≠ 0
  Rational number{}; ///< the radius > 0 of a sphere, the value of a number
};

/// Nothing for kinds that have no form, and for an object that is degenerate.
[[nodiscard]] std::optional<SpatialObject> spatialOf(const Object &object);

/// The line from one point to another; nothing where they are one.
[[nodiscard]] std::optional<SpatialObject> lineThrough(const SpatialObject &from, const SpatialObject &to);

/// Whether both have a direction or a normal, and these make them parallel, or perpendicular. A line in a
/// plane is parallel to it.
[[nodiscard]] bool areParallel(const SpatialObject &a, const SpatialObject &b);
[[nodiscard]] bool arePerpendicular(const SpatialObject &a, const SpatialObject &b);

/// Whether a place is that of a point, or lies on the line, the plane or the sphere of another object, ends
/// and sides of which do not count.
[[nodiscard]] bool contains(const SpatialObject &object, const ExactVec3 &place);
/// Whether the line or the plane of the second lies in that of the first.
[[nodiscard]] bool contains(const SpatialObject &outer, const SpatialObject &inner);

/// The square of the distance from a place to a point, a line or a plane.
[[nodiscard]] Rational squaredDistance(const ExactVec3 &place, const SpatialObject &object);

/// The one point of two lines; nothing where there is none, and where they are parallel.
[[nodiscard]] std::optional<ExactVec3> meetingPoint(const SpatialObject &a, const SpatialObject &b);

} // namespace halfspace
