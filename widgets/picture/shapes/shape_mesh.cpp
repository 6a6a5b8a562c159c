#include "widgets/picture/shapes/shape_mesh.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace halfspace {
namespace {

/// About what a shape has: more in a ball or a dashed line, fewer in a tube.
constexpr std::size_t usualCorners = 400;

void addPieces(Mesh &mesh, const LineShape &line, Color color) {
  for (std::size_t i = 1; i < line.path.size(); ++i)
    addDashes(mesh, line.path[i - 1], line.path[i], line.radius, line.rhythm, color);
  if (line.isClosed)
    addDashes(mesh, line.path.back(), line.path.front(), line.radius, line.rhythm, color);
}

/// Colours the corners of a line from the corner `first` on as they lie along it.
void fade(Mesh &mesh, std::size_t first, const LineFade &fade, Place from, Place along, double length) {
  for (std::size_t i = first; i < mesh.positions.size(); ++i) {
    const double way = glm::dot(Place(mesh.positions[i]) - from, along);
    const double left = fade.isAtBothEnds ? std::min(way, length - way) : length - way;
    const double strength = std::lerp(fadedStrength, 1.0, std::clamp(left / fade.length, 0.0, 1.0));
    mesh.colors[i] = mix(fade.into, mesh.colors[i], strength);
  }
}

void addFadingLine(Mesh &mesh, const LineShape &line, Color color) {
  const Place from = line.path.front();
  const Place to = line.path.back();
  const double length = glm::distance(from, to);
  if (!(length > 0))
    return;
  const Place along = (to - from) / length;
  const Place faded = along * line.fade->length;
  const std::size_t first = mesh.positions.size();
  if (line.rhythm.empty()) // with corners where it begins to fade
    addTube(mesh, std::array{from, from + faded, to - faded, to}, line.radius, color);
  else
    addPieces(mesh, line, color);
  fade(mesh, first, *line.fade, from, along, length);
}

void add(Mesh &mesh, const LineShape &line, Color color) {
  if (line.path.empty())
    return;
  if (line.fade)
    addFadingLine(mesh, line, color);
  else if (!line.rhythm.empty())
    addPieces(mesh, line, color);
  else if (line.isClosed)
    addRing(mesh, line.path, line.radius, color);
  else
    addTube(mesh, line.path, line.radius, color);
}

void add(Mesh &mesh, const ArrowShape &arrow, Color color) {
  addArrow(mesh, arrow.from, arrow.vector, arrow.radius, color, arrow.rhythm);
}

void add(Mesh &mesh, const BallShape &ball, Color color) {
  addBall(mesh, ball.center, ball.radius, color, ball.isOneOfMany ? BallDetail::Coarse : BallDetail::Fine);
}

void add(Mesh &mesh, const FaceShape &face, Color color) { addFlat(mesh, face.corners, color); }

// These are no part of a mesh.
void add(Mesh &, const BodyShape &, Color) {}
void add(Mesh &, const HairlineShape &, Color) {}
void add(Mesh &, const LeaderShape &, Color) {}
void add(Mesh &, const LabelShape &, Color) {}

} // namespace

Mesh meshOf(const std::vector<Shape> &shapes) {
  Mesh mesh;
  makeRoom(mesh, shapes.size() * usualCorners);
  for (const Shape &shape : shapes)
    std::visit([&](const auto &form) { add(mesh, form, shape.color); }, shape.form);
  return mesh;
}

} // namespace halfspace
