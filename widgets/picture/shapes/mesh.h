// Triangle meshes of tubes, cones and balls, as plain arrays: fast enough to be made anew at every step of a
// drag.
#pragma once

#include "lessons/figure/mark.h"
#include "widgets/picture/shapes/rhythm.h"
#include "widgets/picture/theme.h"

#include <glm/ext/vector_int3.hpp>
#include <glm/vec3.hpp>

#include <span>

namespace halfspace {

/// Corners with their normals and colours, and triangles of three corners by their numbers.
struct Mesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<Color> colors;
  std::vector<glm::ivec3> triangles;
};

/// Leaves it empty, with the room that it had.
void clear(Mesh &mesh);

/// A tube around a path with mitred corners and flat ends. Repeated points of the path are left out; a path
/// without length gives nothing.
void addTube(Mesh &mesh, std::span<const Place> path, double radius, Color color);
void addTube(Mesh &mesh, Place from, Place to, double radius, Color color);

/// A tube around a closed path, whose last point is joined to the first.
void addRing(Mesh &mesh, std::span<const Place> corners, double radius, Color color);

/// The corners of a circle around a unit axis.
[[nodiscard]] std::vector<Place> circleAround(Place center, Place axis, double radius, int corners);

/// Short tubes with gaps between, in a rhythm that is not empty, stretched or shrunk as it takes for a dash
/// to begin and one to end at the ends.
void addDashes(Mesh &mesh, Place from, Place to, double radius, const Rhythm &rhythm, Color color);

/// A cone with its base.
void addCone(Mesh &mesh, Place base, Place tip, double radius, Color color);

/// Coarse balls have a sixth of the triangles: for pictures of very many.
enum class BallDetail { Fine, Coarse };

void addBall(Mesh &mesh, Place center, double radius, Color color, BallDetail detail = BallDetail::Fine);

/// A flat convex polygon, seen from both sides.
void addFlat(Mesh &mesh, std::span<const Place> corners, Color color);

/// The head of an arrow, in the measure of the arrow.
struct ArrowHead {
  double length;
  double radius; ///< of its base
};
[[nodiscard]] ArrowHead headOfArrow(double length, double radius);

/// An arrow whose head is in proportion to the radius of its shaft; a short arrow has a smaller head.
/// Its shaft is drawn in a rhythm.
void addArrow(Mesh &mesh, Place from, Place vector, double radius, Color color, const Rhythm &rhythm = {});

} // namespace halfspace
