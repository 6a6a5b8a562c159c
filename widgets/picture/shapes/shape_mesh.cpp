#include "widgets/picture/shapes/shape_mesh.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace halfspace {
namespace {

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

void add(Mesh &mesh, const Shape &shape) {
  std::visit([&](const auto &form) { add(mesh, form, shape.color); }, shape.form);
}

/// Appends values of [begin, end).
template <class Value>
void append(std::vector<Value> &to, const std::vector<Value> &from, std::size_t begin, std::size_t end) {
  to.insert(to.end(), from.data() + begin, from.data() + end);
}

} // namespace

const Mesh &MeshSequence::meshOf(const ShapeLayer &shapes) {
  std::swap(m_now, m_before);
  m_now.shapes = shapes;
  m_now.begins.clear();
  clear(m_now.mesh);
  for (std::size_t i = 0; i < shapes->size(); ++i) {
    m_now.begins.push_back({m_now.mesh.positions.size(), m_now.mesh.triangles.size()});
    if (i < m_before.shapes->size() && (*m_before.shapes)[i] == (*shapes)[i])
      appendBefore(i);
    else
      add(m_now.mesh, (*shapes)[i]);
  }
  m_now.begins.push_back({m_now.mesh.positions.size(), m_now.mesh.triangles.size()});
  return m_now.mesh;
}

void MeshSequence::appendBefore(std::size_t shape) {
  const Begin begin = m_before.begins[shape];
  const Begin end = m_before.begins[shape + 1];
  Mesh &mesh = m_now.mesh;
  const auto shift =
      static_cast<std::int32_t>(mesh.positions.size()) - static_cast<std::int32_t>(begin.corner);
  append(mesh.positions, m_before.mesh.positions, begin.corner, end.corner);
  append(mesh.normals, m_before.mesh.normals, begin.corner, end.corner);
  append(mesh.colors, m_before.mesh.colors, begin.corner, end.corner);
  append(mesh.triangles, m_before.mesh.triangles, begin.triangle, end.triangle);
  for (std::size_t i = mesh.triangles.size() - (end.triangle - begin.triangle); i < mesh.triangles.size();
       ++i)
    mesh.triangles[i] += shift;
}

} // namespace halfspace
