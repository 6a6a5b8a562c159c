#include "widgets/picture/hand/mark_picker.h"

#include "geometry/decide.h"
#include "geometry/search/hit_search.h"
#include "widgets/picture/design_scale.h"
#include "widgets/picture/screen_shapes.h"
#include "widgets/picture/shapes/mark_outline.h"
#include "widgets/picture/shapes/mark_shapes.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halfspace {
namespace {

/// A polygon is preferred to the plane it lies in although both are as far away: it is seen this much nearer.
constexpr double polygonAdvantage = 1e-6;

/// The distance on the screen from a pixel to a point or an open path; infinite where all of it is behind the
/// eye.
double distanceOnScreen(glm::dvec2 pixel, const std::vector<Place> &path, const Camera &camera,
                        PixelSize size) {
  double nearest = std::numeric_limits<double>::infinity();
  std::optional<glm::dvec3> previous;
  for (const Place &place : path) {
    const std::optional<glm::dvec3> current = camera.project(place, size);
    if (current)
      nearest = std::min(
          nearest, distanceToSegment(pixel, glm::dvec2(previous.value_or(*current)), glm::dvec2(*current)));
    previous = current;
  }
  return nearest;
}

/// How far along the sight a convex face is met, or nothing. It has corners.
std::optional<double> distanceToFace(const SightLine &sight, const std::vector<Place> &corners) {
  Place normal(0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    normal += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  const double slope = glm::dot(normal, sight.direction);
  if (slope == 0)
    return {};
  const double distance = glm::dot(corners[0] - sight.origin, normal) / slope;
  if (!(distance > 0))
    return {};
  const Place hit = sight.origin + sight.direction * distance;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Place edge = corners[(i + 1) % corners.size()] - corners[i];
    if (glm::dot(glm::cross(edge, hit - corners[i]), normal) < 0)
      return {};
  }
  return distance;
}

/// How far along the sight a body is met, or nothing.
std::optional<double> distanceToBody(const SightLine &sight, const MeshMark &body) {
  const glm::dmat3 back = glm::inverse(body.axes);
  const Ray<double> own{back * (sight.origin - body.place), back * sight.direction};
  const SearchResult found = body.search->search(exactly(own));
  return found.nearest ? std::optional(toDouble(found.nearest->t)) : std::nullopt;
}

} // namespace

std::string markUnder(glm::dvec2 pixel, const Figure &figure, const Camera &camera, PixelSize size,
                      double pixelRatio) {
  const SightLine sight = camera.sightThrough(pixel, size);
  const double scale = designScale(camera, size, pixelRatio);
  struct Nearest {
    std::string id;
    double distance;
  };
  const double reach = markPickDistance * pixelRatio;
  Nearest point{"", reach + freePointRadius * scale / camera.unitsPerPixel(camera.target, size)};
  Nearest line{"", reach};
  Nearest face{"", std::numeric_limits<double>::infinity()};
  const auto offer = [](Nearest &nearest, const MarkBase &mark, double distance) {
    if (distance <= nearest.distance)
      nearest = {mark.id, distance};
  };
  for (const Mark &mark : figure.marks) {
    const MarkBase &base = baseOf(mark);
    const MarkOutline outline = outlineOf(mark, rightAngleSize * scale);
    if (outline.path.empty())
      continue;
    switch (outline.kind) {
    case MarkOutline::Kind::Point:
      offer(point, base, distanceOnScreen(pixel, outline.path, camera, size));
      break;
    case MarkOutline::Kind::Line:
      offer(line, base, distanceOnScreen(pixel, outline.path, camera, size));
      break;
    case MarkOutline::Kind::Face:
      if (const std::optional<double> distance = distanceToFace(sight, outline.path))
        offer(face, base, *distance * (std::holds_alternative<PolygonMark>(mark) ? 1 - polygonAdvantage : 1));
      break;
    case MarkOutline::Kind::Body:
      if (const std::optional<double> distance = distanceToBody(sight, std::get<MeshMark>(mark)))
        offer(face, base, *distance);
      break;
    }
  }
  return !point.id.empty() ? point.id : !line.id.empty() ? line.id : face.id;
}

} // namespace halfspace
