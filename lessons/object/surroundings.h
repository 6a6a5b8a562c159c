// What objects have that the handles of others can snap to.
#pragma once

#include "lessons/object/quadric.h"

#include <functional>

namespace halfspace {

struct NamedPoint {
  ExactVec3 at;
  std::string name; ///< “vertex P₁”
};

struct NamedEdge {
  ExactVec3 from;
  ExactVec3 to;
  std::string name; ///< “edge P₀P₁”
};

struct NamedLine {
  ExactVec3 through;
  ExactVec3 direction; ///< not zero
  std::string name;    ///< “line g”
};

struct NamedPlane {
  ExactVec3 point;
  ExactVec3 normal; ///< not zero
  std::string name; ///< “E”
};

struct NamedSphere {
  ExactVec3 center;
  Rational radius; ///< above 0
  std::string name;
};

/// What the objects around a handle offer.
struct Surroundings {
  std::vector<NamedPoint> points;
  std::vector<NamedEdge> edges;
  std::vector<NamedLine> lines;
  std::vector<NamedPlane> planes;
  std::vector<NamedSphere> spheres;
  ExactVec3 origin{0}; ///< of the scene
};

/// The places that make something special true of a handle, and the words for it.
struct SnapTarget {
  Flat places;
  std::string name;
  /// Whether a place of the flat counts: between an edge's ends, not a zero direction. Empty: all do.
  std::function<bool(const ExactVec3 &)> counts;
  std::optional<Quadric> surface{}; ///< of the flat's places only those that lie on this

  /// 0 for single places, 1 for a line or a curve, 2 for a plane or a curved surface.
  [[nodiscard]] std::size_t dimension() const { return places.dimension() - (surface ? 1 : 0); }
};

/// Adds what every position catches at: points, edges, lines, planes, the origin.
void aimAtPlaces(const Surroundings &found, std::vector<SnapTarget> &targets);
/// Adds what an arrow from `base` catches at that stands for a direction alone: the axes.
void aimAlongAxes(const ExactVec3 &base, std::vector<SnapTarget> &targets);
/// Adds what an arrow from `base` catches at that leads somewhere: through a point or an edge, parallel to a
/// plane or in it, up to a plane, along an axis, and so that its line touches a sphere.
void aimAtSurroundings(const Surroundings &found, const ExactVec3 &base, std::vector<SnapTarget> &targets);
/// Adds where the start of an arrow catches that leads somewhere: from there the arrow, ≠ 0, points through a
/// point or an edge, or its line touches a sphere.
void aimFromStart(const Surroundings &found, const ExactVec3 &arrow, std::vector<SnapTarget> &targets);
/// Adds what a plane's normal from `base` catches at beside the axes: parallel and perpendicular to planes.
void aimNormal(const Surroundings &found, const ExactVec3 &base, std::vector<SnapTarget> &targets);
/// Adds where a plane of this normal, moved along it, goes through a point or the origin, or becomes one with
/// another plane.
void aimOffset(const Surroundings &found, const ExactVec3 &normal, std::vector<SnapTarget> &targets);

} // namespace halfspace
