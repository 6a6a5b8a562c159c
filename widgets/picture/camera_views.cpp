#include "widgets/picture/camera_views.h"

#include "widgets/picture/shapes/ground.h"
#include "widgets/picture/stage.h"

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halfspace {
namespace {

/// What is in view at home keeps this far from the edges, in design pixels: room for a label.
constexpr double homeMargin = 32;
/// … but no more than this part of the view.
constexpr double largestHomeMargin = 0.13;

/// The normal of a mark that is drawn as part of a plane.
std::optional<Place> normalOf(const Mark &mark) {
  if (const auto *patch = std::get_if<PlanePatchMark>(&mark))
    return patch->normal;
  if (const auto *polygon = std::get_if<PolygonMark>(&mark))
    return glm::cross(polygon->corners[1] - polygon->corners[0], polygon->corners[2] - polygon->corners[0]);
  return {};
}

} // namespace

std::vector<Place> placesOf(const Figure &figure) {
  std::vector<Place> places;
  const auto add = [&](const std::vector<Place> &more) {
    std::copy_if(more.begin(), more.end(), std::back_inserter(places), [](const Place &place) {
      return glm::all(glm::lessThanEqual(glm::abs(place), Place(stageReach)));
    });
  };
  for (const Mark &mark : figure.marks)
    std::visit(Overloaded{[&](const PointMark &point) { add({point.at}); },
                          [&](const SegmentMark &segment) {
                            add({segment.from, segment.to});
                          },
                          [&](const RayMark &ray) { add({ray.origin}); },
                          [&](const LineMark &line) {
                            add({line.through});
                            add(line.covers);
                          },
                          [&](const ArrowMark &arrow) {
                            add({arrow.from, arrow.from + shownVector(arrow)});
                          },
                          [&](const PlanePatchMark &patch) { add(cornersOf(patch)); },
                          [&](const PolygonMark &polygon) { add(polygon.corners); },
                          [&](const SphereMark &sphere) {
                            add({sphere.center - Place(sphere.radius), sphere.center + Place(sphere.radius)});
                          },
                          [&](const ArcMark &arc) { add({arc.center}); },
                          [&](const RightAngleMark &corner) { add({corner.at}); }},
               mark);
  return places;
}

Camera homeView(const CameraView &view, const Figure &figure, bool axes, PixelSize size, double pixelRatio,
                bool orthographic) {
  Camera camera(view);
  camera.orthographic = orthographic;
  std::vector<Place> places = placesOf(figure);
  if (axes)
    for (const AxisEnds &axis : axisEnds(axesAround(figure)))
      places.push_back(axis.high);
  return fitted(camera, places, size, std::min(homeMargin * pixelRatio, largestHomeMargin * size.height));
}

Camera seenAlong(AxisView view, Camera camera) {
  camera.azimuth = view == AxisView::Right ? std::numbers::pi / 2 : 0;
  camera.elevation = view == AxisView::Top ? Camera::maxElevation : 0;
  return camera;
}

Camera seenAlongPlane(const Figure &figure, Camera camera) {
  for (const Mark &mark : figure.marks)
    if (const auto normal = normalOf(mark)) {
      camera.azimuth = std::atan2(normal->y, normal->x) + std::numbers::pi / 2;
      camera.elevation = 0;
      return camera;
    }
  return camera;
}

std::optional<RayObject> firstRay(const Scene &scene) {
  for (const Entry &entry : scene.entries) {
    const auto *object = std::get_if<Object>(&entry.content);
    auto ray = object ? objectAs<RayObject>(*object) : std::nullopt;
    if (ray && !isZero(ray->direction))
      return ray;
  }
  return {};
}

Camera seenDownRay(const Scene &scene, Camera camera) {
  const auto ray = firstRay(scene);
  if (!ray)
    return camera;
  Camera down(CameraView{-toDouble(ray->direction), toDouble(ray->origin), camera.height});
  down.orthographic = camera.orthographic;
  return down;
}

Camera between(const Camera &from, const Camera &to, double t) {
  Camera camera = to;
  camera.target = from.target + (to.target - from.target) * t;
  camera.azimuth = from.azimuth + std::remainder(to.azimuth - from.azimuth, 2 * std::numbers::pi) * t;
  camera.elevation = from.elevation + (to.elevation - from.elevation) * t;
  camera.height = from.height + (to.height - from.height) * t;
  return camera;
}

} // namespace halfspace
