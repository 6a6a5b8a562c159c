#include "widgets/picture/shapes/mark_outline.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halfspace {
namespace {

using Kind = MarkOutline::Kind;

constexpr int arcPieces = 28;
constexpr int circlePieces = 64;

/// An arc is this much larger than the corner of a right angle.
constexpr double arcPerCorner = 1.8;

/// Goes on with a part of a circle around a centre, from one radius through an angle towards another at a
/// right angle to it.
void addArc(std::vector<Place> &path, Place center, Place from, Place across, double angle, int pieces) {
  for (int i = 0; i <= pieces; ++i) {
    const double turned = angle * i / pieces;
    path.push_back(center + from * std::cos(turned) + across * std::sin(turned));
  }
}

std::vector<Place> arcPath(const ArcMark &arc, double radius) {
  if (arc.from == Place(0) || arc.to == Place(0))
    return {};
  const Place start = glm::normalize(arc.from);
  const Place end = glm::normalize(arc.to);
  const double angle = std::atan2(glm::length(glm::cross(start, end)), glm::dot(start, end));
  Place axis = glm::cross(start, end);
  if (axis == Place(0)) // a straight angle: any half circle shows it
    axis = glm::cross(start, std::abs(start.z) < 0.9 ? Place(0, 0, 1) : Place(1, 0, 0));
  const Place across = glm::cross(glm::normalize(axis), start);
  std::vector<Place> path;
  addArc(path, arc.center, start * radius, across * radius, angle, arcPieces);
  return path;
}

/// Three great circles in one path: around z, around y, and after a quarter of the first around x.
std::vector<Place> greatCircles(const SphereMark &sphere) {
  std::vector<Place> path;
  if (!(sphere.radius > 0))
    return path;
  constexpr double whole = 2 * std::numbers::pi;
  const Place x(sphere.radius, 0, 0);
  const Place y(0, sphere.radius, 0);
  const Place z(0, 0, sphere.radius);
  addArc(path, sphere.center, x, y, whole, circlePieces);
  addArc(path, sphere.center, x, z, whole, circlePieces);
  addArc(path, sphere.center, x, y, whole / 4, circlePieces / 4);
  addArc(path, sphere.center, y, z, whole, circlePieces);
  return path;
}

std::vector<Place> boxCornersOf(const MeshMark &mesh) {
  const auto &[low, high] = mesh.box;
  std::vector<Place> corners;
  for (const double x : {low.x, high.x})
    for (const double y : {low.y, high.y})
      for (const double z : {low.z, high.z})
        corners.push_back(mesh.place + mesh.axes * Place(x, y, z));
  return corners;
}

std::vector<Place> cornerPath(const RightAngleMark &corner, double size) {
  if (corner.first == Place(0) || corner.second == Place(0))
    return {};
  const Place a = glm::normalize(corner.first) * size;
  const Place b = glm::normalize(corner.second) * size;
  return {corner.at + a, corner.at + a + b, corner.at + b};
}

} // namespace

MarkOutline outlineOf(const Mark &mark, double size) {
  MarkOutline outline =
      std::visit(Overloaded{
                     [](const PointMark &point) {
                       return MarkOutline{Kind::Point, {point.at}};
                     },
                     [](const SegmentMark &segment) {
                       return MarkOutline{Kind::Line, {segment.from, segment.to}};
                     },
                     [](const RayMark &ray) {
                       return MarkOutline{Kind::Line, {ray.origin, endOf(ray)}};
                     },
                     [](const LineMark &line) {
                       const auto [low, high] = endsOf(line);
                       return MarkOutline{Kind::Line, {low, high}};
                     },
                     [](const ArrowMark &arrow) {
                       return MarkOutline{Kind::Line, {arrow.from, arrow.from + shownVector(arrow)}};
                     },
                     [](const PlanePatchMark &patch) {
                       return MarkOutline{Kind::Face, cornersOf(patch)};
                     },
                     [](const PolygonMark &polygon) {
                       return MarkOutline{Kind::Face, polygon.corners};
                     },
                     [](const SphereMark &sphere) {
                       return MarkOutline{Kind::Line, greatCircles(sphere)};
                     },
                     [](const MeshMark &mesh) {
                       return MarkOutline{Kind::Body, boxCornersOf(mesh)};
                     },
                     [&](const ArcMark &arc) {
                       return MarkOutline{Kind::Line, arcPath(arc, size * arcPerCorner)};
                     },
                     [&](const RightAngleMark &corner) {
                       return MarkOutline{Kind::Line, cornerPath(corner, size)};
                     },
                 },
                 mark);
  if (!std::all_of(outline.path.begin(), outline.path.end(), isFinite))
    outline.path.clear();
  return outline;
}

} // namespace halfspace
