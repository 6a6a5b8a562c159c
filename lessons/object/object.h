// The objects of a scene: what can be dragged and typed.
#pragma once

#include "geometry/vector.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace halfspace {

using ExactVec3 = Vec3<Rational>;

/// A free point.
struct PointObject {
  ExactVec3 at{};
  bool operator==(const PointObject &) const = default;
};

/// A plane by a point of it and its normal.
struct PlaneObject {
  ExactVec3 point{};
  ExactVec3 normal{};
  bool operator==(const PlaneObject &) const = default;
};

/// A ray by its start and its direction, which keeps its length.
struct RayObject {
  ExactVec3 origin{};
  ExactVec3 direction{};
  bool operator==(const RayObject &) const = default;
};

/// A triangle by its corners.
struct TriangleObject {
  ExactVec3 p0{};
  ExactVec3 p1{};
  ExactVec3 p2{};
  bool operator==(const TriangleObject &) const = default;
};

/// The closed set of objects. A new kind needs its word and its coordinates below, from which the file
/// format, inspector rows, the names for --set and the handles of its coordinates follow; and it is named
/// where kinds differ: how it is drawn (object_marks.cpp), handles of its own (scene/handles.cpp), what
/// others snap to on it (scene/snap_targets.cpp), which numbers are short for it (scene/short_numbers.cpp).
using Object = std::variant<PointObject, PlaneObject, RayObject, TriangleObject>;

/// How a coordinate moves: a position is a place in space, a direction an arrow drawn from the object's
/// position.
enum class CoordinateRole { Position, Direction };

/// One of an object's coordinates, by the name that the notes give it. A point's only coordinate has no name
/// of its own: it goes by the point's.
struct CoordinateSpec {
  std::string_view name;
  CoordinateRole role;
};

/// The word for the object's kind in files: point, plane, ray, triangle.
[[nodiscard]] std::string_view kindOf(const Object &object);

/// The kinds' words, in the order of `Object`.
[[nodiscard]] const std::vector<std::string_view> &objectKinds();

/// An object of this kind with all coordinates zero, or nothing for an unknown word.
[[nodiscard]] std::optional<Object> makeObject(std::string_view kind);

/// Names and roles of the object's coordinates. The first is always the position that the others start from.
[[nodiscard]] const std::vector<CoordinateSpec> &coordinatesOf(const Object &object);

/// The coordinate at an index of `coordinatesOf`.
[[nodiscard]] const ExactVec3 &coordinate(const Object &object, std::size_t index);
[[nodiscard]] ExactVec3 &coordinate(Object &object, std::size_t index);

} // namespace halfspace
