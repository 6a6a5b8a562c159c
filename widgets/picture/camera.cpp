#include "widgets/picture/camera.h"

#include "geometry/bounding_box.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

namespace halfspace {
namespace {

const double slopeOfView = std::tan(Camera::viewAngle / 2);

/// Where the eye of an orthographic camera stands: so far that whatever a scene holds lies before it.
constexpr double orthographicDistance = 1000;

/// No room is taken to be smaller than this part of the view.
constexpr double leastRoom = 0.2;
/// The least height of a fitted view, so that a single point does not fill it.
constexpr double leastFittedHeight = 4;

double unitsPerPixelAtTarget(const Camera &camera, PixelSize size) { return camera.height / size.height; }

/// The place under a pixel at the target's depth, from the target.
Place offsetAtTarget(const Camera &camera, glm::dvec2 pixel, PixelSize size) {
  const glm::dvec2 fromCenter = pixel - glm::dvec2(size.width, size.height) / 2.0;
  return (camera.right() * fromCenter.x - camera.up() * fromCenter.y) * unitsPerPixelAtTarget(camera, size);
}

/// Between which slopes of sight, as the eye looks, places are to lie, for one of the view's two directions;
/// and what that asks of the eye.
///
/// A place at (x, z), z towards the eye, is seen at the slope (x − eye) / (distance − z): that it lies
/// between low and high is linear in `eye` and `distance`. Seen orthographically z does not count, and
/// `distance` only stands for height / (2·slope of the view).
class Slopes {
public:
  Slopes(double low, double high) : m_low(low), m_high(high) {}

  void add(double across, double towardsEye) {
    m_fromLow = std::min(m_fromLow, across + m_low * towardsEye);
    m_fromHigh = std::max(m_fromHigh, across + m_high * towardsEye);
  }
  [[nodiscard]] double leastDistance() const { return (m_fromHigh - m_fromLow) / (m_high - m_low); }
  /// Where the eye has as much room to both sides.
  [[nodiscard]] double eyeAt(double distance) const {
    return (m_fromLow - m_low * distance + m_fromHigh - m_high * distance) / 2;
  }

private:
  double m_low;
  double m_high;
  double m_fromLow = std::numeric_limits<double>::infinity();
  double m_fromHigh = -std::numeric_limits<double>::infinity();
};

/// The room, not smaller than it may be.
PixelBox usableRoom(const PixelBox &room, PixelSize size) {
  const glm::dvec2 middle = (room.low + room.high) / 2.0;
  const glm::dvec2 half = glm::max(room.extent(), glm::dvec2(size.width, size.height) * leastRoom) / 2.0;
  return {middle - half, middle + half};
}

} // namespace

Camera::Camera(const CameraView &view)
    : target(view.at), height(std::clamp(view.height, minHeight, maxHeight)) {
  if (!isFinite(view.from) || view.from == Place(0))
    return;
  azimuth = std::atan2(view.from.y, view.from.x);
  elevation =
      std::clamp(std::atan2(view.from.z, std::hypot(view.from.x, view.from.y)), -maxElevation, maxElevation);
}

double Camera::distance() const { return orthographic ? orthographicDistance : height / 2 / slopeOfView; }

Place Camera::eye() const { return target - viewDirection() * distance(); }

Place Camera::viewDirection() const {
  return -Place(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                std::sin(elevation));
}

Place Camera::right() const { return {-std::sin(azimuth), std::cos(azimuth), 0}; }

Place Camera::up() const { return glm::cross(right(), viewDirection()); }

void Camera::turn(double azimuthChange, double elevationChange) {
  azimuth = std::remainder(azimuth + azimuthChange, 2 * std::numbers::pi);
  elevation = std::clamp(elevation + elevationChange, -maxElevation, maxElevation);
}

void Camera::turnAbout(Place pivot, double azimuthChange, double elevationChange) {
  const Place toTarget = target - pivot;
  const Place seen(glm::dot(toTarget, right()), glm::dot(toTarget, up()),
                   glm::dot(toTarget, viewDirection()));
  turn(azimuthChange, elevationChange);
  target = pivot + right() * seen.x + up() * seen.y + viewDirection() * seen.z;
  target = glm::clamp(target, -farthestTarget, farthestTarget);
}

void Camera::pan(glm::dvec2 pixels, PixelSize size) {
  target -= (right() * pixels.x - up() * pixels.y) * unitsPerPixelAtTarget(*this, size);
  target = glm::clamp(target, -farthestTarget, farthestTarget);
}

void Camera::zoom(double factor, glm::dvec2 pixel, PixelSize size) {
  const Place offset = offsetAtTarget(*this, pixel, size);
  const double before = height;
  height = std::clamp(height * factor, minHeight, maxHeight);
  target = glm::clamp(target + offset * (1 - height / before), -farthestTarget, farthestTarget);
}

std::optional<glm::dvec3> Camera::project(Place place, PixelSize size) const {
  // Once each: a frame projects some hundred places.
  const Place along = viewDirection();
  const Place across = right();
  const Place sight = place - (target - along * distance());
  const double depth = glm::dot(sight, along);
  if (!isFinite(place) || depth <= 0)
    return {};
  const double pixels = 1 / unitsPerPixelAtTarget(*this, size) * (orthographic ? 1 : distance() / depth);
  return glm::dvec3(size.width / 2.0 + glm::dot(sight, across) * pixels,
                    size.height / 2.0 - glm::dot(sight, glm::cross(across, along)) * pixels,
                    depth / (depth + distance()));
}

SightLine Camera::sightThrough(glm::dvec2 pixel, PixelSize size) const {
  const Place through = target + offsetAtTarget(*this, pixel, size);
  if (orthographic)
    return {through - viewDirection() * distance(), viewDirection()};
  return {eye(), glm::normalize(through - eye())};
}

double Camera::unitsPerPixel(Place at, PixelSize size) const {
  const double depth = glm::dot(at - eye(), viewDirection());
  if (depth <= 0)
    return 0;
  return unitsPerPixelAtTarget(*this, size) * (orthographic ? 1 : depth / distance());
}

Camera fitted(Camera camera, const std::vector<Place> &places, PixelSize size, const PixelBox &room) {
  std::vector<Place> finite;
  std::copy_if(places.begin(), places.end(), std::back_inserter(finite), isFinite);
  if (finite.empty())
    return camera;

  // Look at the middle of all of them.
  BoundingBox box;
  for (const Place &place : finite)
    box.include(place);
  camera.target = (box.low + box.high) / 2.0;

  const double slopePerPixel = 2 * slopeOfView / size.height;
  const glm::dvec2 middle = glm::dvec2(size.width, size.height) / 2.0;
  const PixelBox usable = usableRoom(room, size);
  const glm::dvec2 first = (usable.low - middle) * slopePerPixel;
  const glm::dvec2 last = (usable.high - middle) * slopePerPixel;
  Slopes across(first.x, last.x);
  Slopes upward(-last.y, -first.y); // pixels count down
  for (const Place &place : finite) {
    const Place offset = place - camera.target;
    const double towardsEye = camera.orthographic ? 0 : -glm::dot(offset, camera.viewDirection());
    across.add(glm::dot(offset, camera.right()), towardsEye);
    upward.add(glm::dot(offset, camera.up()), towardsEye);
  }
  const double wanted = 2 * slopeOfView * std::max(across.leastDistance(), upward.leastDistance());
  camera.height = std::clamp(wanted, leastFittedHeight, Camera::maxHeight);
  const double distance = camera.height / 2 / slopeOfView;
  camera.target += camera.right() * across.eyeAt(distance) + camera.up() * upward.eyeAt(distance);
  return camera;
}

Camera keptBetweenSides(Camera camera, PixelSize before, PixelSize now) {
  const double narrower =
      static_cast<double>(before.width) * now.height / (static_cast<double>(before.height) * now.width);
  camera.height = std::min(camera.height * std::max(1.0, narrower), Camera::maxHeight);
  return camera;
}

} // namespace halfspace
