#include "widgets/exports/paper.h"

#include "geometry/clip.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace halfspace {
namespace {

/// What is seen beside the page is drawn so far, in parts of its width and height: pens are thick.
constexpr double marginBesidePage = 0.1;

} // namespace

Paper::Paper(const ShapeList &list, double width)
    : m_camera(list.view.camera), m_eye(list.view.camera.eye()), m_along(list.view.camera.viewDirection()),
      m_right(list.view.camera.right()), m_down(-list.view.camera.up()),
      m_isOrthographic(list.view.camera.orthographic), m_distance(list.view.camera.distance()),
      m_pointsPerPixel(width / list.view.size.width), m_designPoint(m_pointsPerPixel * list.view.pixelRatio),
      m_pointsPerUnit(m_pointsPerPixel * list.view.size.height / list.view.camera.height),
      m_size(glm::dvec2(list.view.size.width, list.view.size.height) * m_pointsPerPixel) {
  setBorders(list.view, list.depths.nearest);
}

void Paper::setBorders(const View &view, double nearest) {
  m_borders.push_back(planeThrough(m_eye + m_along * nearest, m_along));
  const glm::dvec2 half = m_size / m_pointsPerUnit * (0.5 + marginBesidePage);
  const auto addSides = [&](const Place &across, double reach) {
    for (const Place &inward : {across, -across})
      m_borders.push_back(m_isOrthographic ? planeThrough(view.camera.target - inward * reach, inward)
                                           : planeThrough(m_eye, inward * m_distance + m_along * reach));
  };
  addSides(m_right, half.x);
  addSides(m_down, half.y);
}

double Paper::depthOf(const Place &place) const { return glm::dot(place - m_eye, m_along); }

Spot Paper::spotOf(const Place &place) const {
  const Place sight = place - m_eye;
  const glm::dvec2 onPage(glm::dot(sight, m_right), glm::dot(sight, m_down));
  const double depth = depthOf(place);
  return {m_size / 2.0 + onPage * pointsPerUnitAt(place), m_isOrthographic ? -depth : 1 / depth};
}

double Paper::pointsPerUnitAt(const Place &place) const {
  return m_pointsPerUnit * (m_isOrthographic ? 1 : m_distance / depthOf(place));
}

bool Paper::isSeen(const Place &place) const {
  return std::all_of(m_borders.begin(), m_borders.end(),
                     [&](const Plane<double> &border) { return evaluate(border, place) >= 0; });
}

Place Paper::sightTo(const Place &place) const {
  return m_isOrthographic ? m_along * depthOf(place) : place - m_eye;
}

Silhouette Paper::silhouetteOf(const Globe &ball) const {
  SphereMark mark;
  mark.center = ball.center;
  mark.radius = ball.radius;
  return halfspace::silhouetteOf(mark, m_camera).value();
}

std::optional<std::pair<double, double>> Paper::seenPart(const Place &from, const Place &to) const {
  double begin = 0;
  double end = 1;
  for (const Plane<double> &border : m_borders) {
    const double first = evaluate(border, from);
    const double last = evaluate(border, to);
    if (first < 0 && last < 0)
      return {};
    if (first < 0)
      begin = std::max(begin, first / (first - last));
    else if (last < 0)
      end = std::min(end, first / (first - last));
  }
  return begin < end ? std::optional(std::pair(begin, end)) : std::nullopt;
}

std::vector<Place> Paper::seenPart(std::vector<Place> corners) const {
  for (const Plane<double> &border : m_borders)
    corners = clipPolygon<double>(corners, border);
  return corners;
}

} // namespace halfspace
