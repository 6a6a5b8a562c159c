#include "widgets/picture/camera_views.h"

#include "geometry/bounding_box.h"
#include "widgets/picture/free_rooms.h"
#include "widgets/picture/screen_shapes.h"
#include "widgets/picture/shapes/ground.h"
#include "widgets/picture/shapes/mark_outline.h"
#include "widgets/picture/stage.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halfspace {
namespace {

/// What is fitted into a view keeps this far from its edges, in design pixels: room for a label …
constexpr double labelMargin = 32;
/// … but no more than this part of its shorter side.
constexpr double largestMargin = 0.13;

/// No view is made to show what lies farther from what is given than so many times its size.
constexpr double reachOfGiven = 2;

/// The normal of a mark that is drawn as part of a plane.
std::optional<Place> normalOf(const Mark &mark) {
  if (const auto *patch = std::get_if<PlanePatchMark>(&mark))
    return patch->normal;
  if (const auto *polygon = std::get_if<PolygonMark>(&mark))
    return glm::cross(polygon->corners[1] - polygon->corners[0], polygon->corners[2] - polygon->corners[0]);
  return {};
}

/// Of the first plane or triangle of a figure.
std::optional<Place> firstNormal(const Figure &figure) {
  for (const Mark &mark : figure.marks)
    if (const auto normal = normalOf(mark))
      return normal;
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
                          [&](const MeshMark &mesh) { add(outlineOf(mesh, 1).path); },
                          [&](const ArcMark &arc) { add({arc.center}); },
                          [&](const RightAngleMark &corner) { add({corner.at}); }},
               mark);
  return places;
}

Figure nearGiven(Figure figure) {
  Figure given;
  for (const Mark &mark : figure.marks)
    if (baseOf(mark).role == Role::Given)
      given.marks.push_back(mark);
  const std::vector<Place> places = placesOf(given);
  if (places.empty())
    return figure;
  BoundingBox box;
  for (const Place &place : places)
    box.include(place);
  const Place reach(reachOfGiven * box.longestSide());
  figure.marks.eraseIf([&](const Mark &mark) {
    const std::vector<Place> of = placesOf({{mark}});
    return std::any_of(of.begin(), of.end(), [&](const Place &place) {
      return glm::any(glm::lessThan(place, box.low - reach)) ||
             glm::any(glm::greaterThan(place, box.high + reach));
    });
  });
  return figure;
}

std::vector<Place> axisTips(const Figure &figure) {
  std::vector<Place> tips;
  for (const AxisEnds &axis : axisEnds(axesAround(figure)))
    tips.insert(tips.end(), {axis.low, axis.high});
  return tips;
}

std::vector<Place> placesNearGiven(const Figure &figure, bool axes) {
  const Figure near = nearGiven(figure);
  std::vector<Place> places = placesOf(near);
  if (axes) {
    const std::vector<Place> tips = axisTips(near);
    places.insert(places.end(), tips.begin(), tips.end());
  }
  return places;
}

Camera cameraOf(const ChosenView &chosen) {
  Camera camera(chosen.view);
  camera.orthographic = chosen.orthographic;
  return camera;
}

ChosenView chosenViewOf(const Camera &camera) {
  return {{-camera.viewDirection(), camera.target, camera.height}, camera.orthographic};
}

Camera fitted(const View &view, const std::vector<Place> &places) {
  const int side = std::min(view.size.width, view.size.height);
  const double margin = std::min(labelMargin * view.pixelRatio, largestMargin * side);
  const auto fittedInto = [&](const PixelBox &room) {
    return fitted(view.camera, places, view.size, grown(room, -margin));
  };
  const auto isFree = [&](const Camera &camera) {
    return std::none_of(places.begin(), places.end(), [&](const Place &place) {
      const auto pixel = camera.project(place, view.size);
      return pixel && std::any_of(view.covered.begin(), view.covered.end(), [&](const PixelBox &box) {
               return distanceTo(box, glm::dvec2(*pixel)) < margin;
             });
    });
  };
  // Often nothing of the figure lies in the corners that are covered.
  const Camera largest = fittedInto(view.box());
  if (isFree(largest))
    return largest;
  std::optional<Camera> best;
  for (const PixelBox &room : freeRooms(view.box(), view.covered))
    if (const Camera camera = fittedInto(room); !best || camera.height < best->height)
      best = camera;
  return best.value_or(largest);
}

Camera homeView(const CameraView &from, const Figure &figure, bool axes, PixelSize size, double pixelRatio) {
  return fitted({Camera(from), size, pixelRatio}, placesNearGiven(figure, axes));
}

Camera seenAlong(AxisView view, Camera camera) {
  camera.azimuth = view == AxisView::Right ? std::numbers::pi / 2 : 0;
  camera.elevation = view == AxisView::Top ? Camera::maxElevation : 0;
  return camera;
}

bool showsPlane(const Figure &figure) { return firstNormal(figure).has_value(); }

Camera seenAlongPlane(const Figure &figure, Camera camera) {
  if (const auto normal = firstNormal(figure)) {
    camera.azimuth = std::atan2(normal->y, normal->x) + std::numbers::pi / 2;
    camera.elevation = 0;
  }
  return camera;
}

Camera seenFacingPlane(const Figure &figure, Camera camera) {
  const auto normal = firstNormal(figure);
  if (!normal)
    return camera;
  const bool isBehind = glm::dot(*normal, camera.viewDirection()) > 0;
  const Camera facing(CameraView{isBehind ? -*normal : *normal, camera.target, camera.height});
  camera.azimuth = facing.azimuth;
  camera.elevation = facing.elevation;
  return camera;
}

Place middleInView(const View &view, const std::vector<Place> &places) {
  BoundingBox box;
  for (const Place &place : places) {
    const auto pixel = view.camera.project(place, view.size);
    if (pixel && pixel->x >= 0 && pixel->y >= 0 && pixel->x <= view.size.width &&
        pixel->y <= view.size.height)
      box.include(place);
  }
  return box.low.x > box.high.x ? view.camera.target : (box.low + box.high) / 2.0;
}

std::optional<Course> firstCourse(const Figure &figure) {
  for (const Mark &mark : figure.marks) {
    if (const auto *ray = std::get_if<RayMark>(&mark))
      return Course{ray->origin, ray->direction};
    if (const auto *line = std::get_if<LineMark>(&mark))
      return Course{line->through, line->direction};
  }
  return {};
}

Camera seenAlongCourse(AlongCourse way, const Figure &figure, Camera camera) {
  const auto course = firstCourse(figure);
  if (!course)
    return camera;
  const Place from = way == AlongCourse::Down ? -course->direction : course->direction;
  Camera along(CameraView{from, course->start, camera.height});
  along.orthographic = camera.orthographic;
  return along;
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
