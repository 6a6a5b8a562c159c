#include "widgets/exports/paper.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace halfspace {

double Paper::Border::side(const Place &place) const { return glm::dot(normal, place) + offset; }

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
  m_borders.push_back({m_along, -glm::dot(m_along, m_eye) - nearest});
  const glm::dvec2 half = m_size / m_pointsPerUnit * (0.5 + marginBesidePage);
  const auto addSides = [&](const Place &across, double reach) {
    for (const Place &inward : {across, -across})
      if (m_isOrthographic) {
        m_borders.push_back({inward, reach - glm::dot(inward, view.camera.target)});
      } else {
        const Place normal = inward * m_distance + m_along * reach;
        m_borders.push_back({normal, -glm::dot(normal, m_eye)});
      }
  };
  addSides(m_right, half.x);
  addSides(m_down, half.y);
}

double Paper::depthOf(const Place &place) const { return glm::dot(place - m_eye, m_along); }

Spot Paper::spotOf(const Place &place) const {
  const Place sight = place - m_eye;
  const double depth = glm::dot(sight, m_along);
  const double scale = m_pointsPerUnit * (m_isOrthographic ? 1 : m_distance / depth);
  return {m_size / 2.0 + glm::dvec2(glm::dot(sight, m_right), glm::dot(sight, m_down)) * scale, depth};
}

double Paper::pointsPerUnitAt(const Place &place) const {
  return m_pointsPerUnit * (m_isOrthographic ? 1 : m_distance / depthOf(place));
}

bool Paper::isSeen(const Place &place) const {
  return std::all_of(m_borders.begin(), m_borders.end(),
                     [&](const Border &border) { return border.side(place) >= 0; });
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
  for (const Border &border : m_borders) {
    const double first = border.side(from);
    const double last = border.side(to);
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
  for (const Border &border : m_borders) {
    std::vector<Place> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Place &corner = corners[i];
      const Place &next = corners[(i + 1) % corners.size()];
      const double side = border.side(corner);
      const double nextSide = border.side(next);
      if (side >= 0)
        kept.push_back(corner);
      if ((side < 0) != (nextSide < 0))
        kept.push_back(glm::mix(corner, next, side / (side - nextSide)));
    }
    corners = std::move(kept);
  }
  return corners;
}

} // namespace halfspace
