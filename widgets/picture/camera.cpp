#include "widgets/picture/camera.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace halfspace {
namespace {

const double slopeOfView = std::tan(Camera::viewAngle / 2);

/// Where the eye of an orthographic camera stands: so far that whatever a scene holds lies before it.
constexpr double orthographicDistance = 1000;

/// The part of the view that `fitted` fills at most.
constexpr double fittedPart = 0.86;
/// A margin never takes more of the view than leaves this part.
constexpr double leastFittedPart = 0.4;
/// The least height of a fitted view, so that a single point does not fill it.
constexpr double leastFittedHeight = 4;

double unitsPerPixelAtTarget(const Camera &camera, PixelSize size) { return camera.height / size.height; }

/// The place under a pixel at the target's depth, from the target.
Place offsetAtTarget(const Camera &camera, glm::dvec2 pixel, PixelSize size) {
  const glm::dvec2 fromCenter = pixel - glm::dvec2(size.width, size.height) / 2.0;
  return (camera.right() * fromCenter.x - camera.up() * fromCenter.y) * unitsPerPixelAtTarget(camera, size);
}

/// How far places reach to both sides of the view, for one of its two directions.
struct Span {
  double low = -std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double across, double towardsEye) {
    high = std::max(high, towardsEye + across);
    low = std::max(low, towardsEye - across);
  }
  [[nodiscard]] double middle() const { return (high - low) / 2; }
  [[nodiscard]] double half() const { return (high + low) / 2; }
};

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

Camera fitted(Camera camera, const std::vector<Place> &places, PixelSize size, double margin) {
  std::vector<Place> finite;
  std::copy_if(places.begin(), places.end(), std::back_inserter(finite), isFinite);
  if (finite.empty())
    return camera;

  // Look at the middle of all of them.
  Place low = finite.front();
  Place high = finite.front();
  for (const Place &place : finite) {
    low = glm::min(low, place);
    high = glm::max(high, place);
  }
  camera.target = (low + high) / 2.0;

  // A place at (x, y, z), z towards the eye, is inside the view when |x| ≤ (distance − z)·slope: so each side
  // of the view gives the least distance, and the best centre is where two opposite sides ask for the same.
  // Seen orthographically z does not count, and `distance` only stands for height / (2·slope).
  const auto slopeWithin = [&](int side) {
    const double part = std::clamp(1 - 2 * margin / side, leastFittedPart, fittedPart);
    return slopeOfView * part * side / size.height;
  };
  const double slopeUp = slopeWithin(size.height);
  const double slopeAcross = slopeWithin(size.width);
  Span across;
  Span upward;
  for (const Place &place : finite) {
    const Place offset = place - camera.target;
    const double towardsEye = camera.orthographic ? 0 : -glm::dot(offset, camera.viewDirection());
    across.add(glm::dot(offset, camera.right()) / slopeAcross, towardsEye);
    upward.add(glm::dot(offset, camera.up()) / slopeUp, towardsEye);
  }
  camera.target += camera.right() * across.middle() * slopeAcross + camera.up() * upward.middle() * slopeUp;
  camera.height = std::clamp(2 * slopeOfView * std::max(across.half(), upward.half()), leastFittedHeight,
                             Camera::maxHeight);
  return camera;
}

} // namespace halfspace
