// A view of the stage on a page: where places are seen, in points.
#pragma once

#include "geometry/plane.h"
#include "widgets/picture/shapes/shape_list.h"
#include "widgets/picture/shapes/silhouette.h"

#include <optional>
#include <utility>

namespace halfspace {

/// A place on the page, and how near it is seen.
struct Spot {
  glm::dvec2 at{}; ///< in points
  /// Grows towards the eye, and along a straight line as evenly as the line goes over the page: the depth
  /// does not, in perspective.
  double nearness = 0;
};

/// Projects as the camera does (Camera::project), in points instead of pixels.
class Paper {
public:
  /// For the view that a list was made for, on a page so many points wide.
  Paper(const ShapeList &list, double width);

  [[nodiscard]] glm::dvec2 size() const { return m_size; }
  [[nodiscard]] double pointsPerPixel() const { return m_pointsPerPixel; }
  /// The points that a design pixel has.
  [[nodiscard]] double designPoint() const { return m_designPoint; }
  /// The points that a unit of the stage has at the camera's target.
  [[nodiscard]] double pointsPerUnit() const { return m_pointsPerUnit; }
  [[nodiscard]] bool isOrthographic() const { return m_isOrthographic; }
  [[nodiscard]] const Place &eye() const { return m_eye; }
  [[nodiscard]] const Place &viewDirection() const { return m_along; }

  /// Where a place is seen that lies before the eye.
  [[nodiscard]] Spot spotOf(const Place &place) const;
  [[nodiscard]] double depthOf(const Place &place) const;
  /// The points that a unit has at a place before the eye.
  [[nodiscard]] double pointsPerUnitAt(const Place &place) const;
  /// Whether a place lies before the eye, and on the page or not far beside it.
  [[nodiscard]] bool isSeen(const Place &place) const;
  /// From the eye to a place (not unit); in an orthographic view, from beside the eye, straight to it.
  [[nodiscard]] Place sightTo(const Place &place) const;
  [[nodiscard]] Place sightFrom(const Place &place) const { return place - sightTo(place); }
  /// The circle in which sights touch a ball that the eye is outside of.
  [[nodiscard]] Silhouette silhouetteOf(const Globe &ball) const;

  /// The part of a segment that is seen, as parts of its way: it lies before the eye, and on the page or not
  /// far beside it.
  [[nodiscard]] std::optional<std::pair<double, double>> seenPart(const Place &from, const Place &to) const;
  /// The part of a convex polygon that is seen; fewer than three corners: nothing is.
  [[nodiscard]] std::vector<Place> seenPart(std::vector<Place> corners) const;

private:
  void setBorders(const View &view, double nearest);

  Camera m_camera;
  Place m_eye{};
  Place m_along{};
  Place m_right{};
  Place m_down{};
  bool m_isOrthographic;
  double m_distance; ///< from the eye to the target
  double m_pointsPerPixel;
  double m_designPoint;
  double m_pointsPerUnit;
  glm::dvec2 m_size;
  std::vector<Plane<double>> m_borders; ///< what is seen lies on their positive sides
};

} // namespace halfspace
