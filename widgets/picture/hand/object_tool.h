// A tool that makes an object of points that are taken one after the other. No screen, no camera.
#pragma once

#include "lessons/scene/scene.h"

namespace halfspace {

/// What a tool makes.
enum class ToolObject {
  Point,
  PointOn, ///< on a plane, a line, a ray, a triangle or a sphere
  Segment,
  Line,
  Ray,
  Vector,
  PlaneThroughPoints,
  PlaneWithNormal,
  Triangle,
  Polygon,
  Sphere,
  Tetrahedron,
  Box,
  Prism
};

/// Something that a tool has taken, or would take: a point of the scene, or a new entry.
struct ToolPick {
  std::string name;             ///< by which formulas know it: `A`, `T.P0`, `hit.H`
  ExactVec3 at{};               ///< where it is, in scene units
  std::optional<Entry> entry{}; ///< that comes into the scene for it; nothing for what is there
  bool operator==(const ToolPick &) const = default;
};

/// What a tool wants next.
struct ToolWish {
  enum class Kind {
    Point,   ///< any point; a new one is on the ground
    Above,   ///< any point; a new one is above or below a place
    Radius,  ///< a number: how far away from a place
    OnObject ///< a point on an object that can have some
  };
  Kind kind = Kind::Point;
  ExactVec3 from{}; ///< the place that it is told from, in scene units; of a point on the ground the origin
  bool operator==(const ToolWish &) const = default;
};

/// A tool with what it has taken so far.
struct ObjectTool {
  ToolObject object = ToolObject::Point;
  std::vector<ToolPick> picks{};
  std::size_t corners = 0; ///< of a polygon, or a prism's base, that is closed; 0 of others
  bool operator==(const ObjectTool &) const = default;
};

/// What the tool wants next; nothing once it has all.
[[nodiscard]] std::optional<ToolWish> wishOf(const ObjectTool &tool);

/// Whether the corners of a polygon or a base are enough to be closed, by its first corner.
[[nodiscard]] bool canClose(const ObjectTool &tool);
/// Whether the tool can take what goes by a name: nothing twice, but the first corner to close with.
[[nodiscard]] bool canTake(const ObjectTool &tool, const std::string &name);
/// The tool with one thing more. Corners are closed by the first one, and once there are as many as can be.
[[nodiscard]] ObjectTool withPick(ObjectTool tool, ToolPick pick);
/// The tool before its last step. Requires one.
[[nodiscard]] ObjectTool withoutLastPick(ObjectTool tool);
/// The tool with its corners closed as they are. Requires that they can be.
[[nodiscard]] ObjectTool withClosedCorners(ObjectTool tool);

/// A new point at a place.
[[nodiscard]] ToolPick newPoint(const ObjectTool &tool, const Scene &scene, const ExactVec3 &at);
/// A new number as the radius of the sphere whose centre the tool has taken. `unit`: a usual length there.
[[nodiscard]] ToolPick newRadius(const ObjectTool &tool, const Scene &scene, const Rational &radius,
                                 const Rational &unit);
/// A new point on an object: by its freedoms, and at the place where it then lies.
[[nodiscard]] ToolPick newPointOn(const ObjectTool &tool, const Scene &scene, const std::string &host,
                                  const Object &bound, const ExactVec3 &at);

/// The entries that come into a scene, behind those that it has: those of the picks, and, where the tool has
/// all that it wants, the object, whose coordinates are formulas of them.
[[nodiscard]] std::vector<Entry> entriesOf(const ObjectTool &tool, const Scene &scene);

} // namespace halfspace
