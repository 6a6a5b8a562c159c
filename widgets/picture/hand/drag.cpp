#include "widgets/picture/hand/drag.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace halfspace {
namespace {

/// The sine of the angle between a sight and what a constraint moves on: the line, or the plane.
double sineOfAngle(const DragConstraint &constraint, Place sight) {
  const Place direction = glm::normalize(constraint.direction);
  return constraint.kind == DragConstraint::Kind::Line ? glm::length(glm::cross(direction, sight))
                                                       : std::abs(glm::dot(direction, sight));
}

std::optional<Place> onPlane(const SightLine &sight, Place at, Place normal) {
  const double distance = glm::dot(at - sight.origin, normal) / glm::dot(sight.direction, normal);
  if (!(distance > 0))
    return {};
  return sight.origin + sight.direction * distance;
}

/// The place of the line that is nearest to the sight.
std::optional<Place> onLine(const SightLine &sight, Place at, Place direction) {
  const Place along = glm::normalize(direction);
  const Place toStart = at - sight.origin;
  const double cosine = glm::dot(sight.direction, along);
  const double step =
      (cosine * glm::dot(toStart, sight.direction) - glm::dot(toStart, along)) / (1 - cosine * cosine);
  const Place place = at + along * step;
  if (!(glm::dot(place - sight.origin, sight.direction) > 0))
    return {};
  return place;
}

/// The place of a sphere's outline that is nearest to a sight that passes it by, from an eye outside.
Place onOutline(const SightLine &sight, Place center, double radius, const Camera &camera) {
  const Place aside =
      sight.origin + sight.direction * glm::dot(center - sight.origin, sight.direction) - center;
  if (camera.orthographic)
    return center + glm::normalize(aside) * radius;
  const Place toEye = camera.eye() - center;
  const double sine = radius / glm::length(toEye);
  const Place ahead = glm::normalize(toEye);
  const Place across = glm::normalize(aside - ahead * glm::dot(aside, ahead));
  return center + (ahead * sine + across * std::sqrt(1 - sine * sine)) * radius;
}

/// Where the sight meets the sphere around `center` through `at`, on the side where `at` is; beside the
/// sphere the place of its outline that is nearest to the sight.
std::optional<Place> onSphereAt(const SightLine &sight, Place at, Place center, const Camera &camera) {
  const double radius = glm::length(at - center);
  const double toMiddle = glm::dot(center - sight.origin, sight.direction);
  const Place aside = sight.origin + sight.direction * toMiddle - center;
  const double halfChord = radius * radius - glm::dot(aside, aside);
  if (halfChord <= 0)
    return onOutline(sight, center, radius, camera);
  const Place toAt = camera.orthographic ? camera.viewDirection() : at - camera.eye();
  const bool isFar = glm::dot(at - center, toAt) > 0;
  const double distance = toMiddle + (isFar ? 1 : -1) * std::sqrt(halfChord);
  if (!(distance > 0))
    return {};
  return sight.origin + sight.direction * distance;
}

} // namespace

std::optional<Place> placeUnder(glm::dvec2 pixel, const DragConstraint &constraint, const Camera &camera,
                                PixelSize size, Place at) {
  const SightLine sight = camera.sightThrough(pixel, size);
  if (constraint.kind == DragConstraint::Kind::Sphere)
    return onSphereAt(sight, at, constraint.center, camera);
  if (sineOfAngle(constraint, sight.direction) < std::sin(leastSightAngle))
    return {};
  return constraint.kind == DragConstraint::Kind::Line ? onLine(sight, at, constraint.direction)
                                                       : onPlane(sight, at, constraint.direction);
}

bool isGrabbable(const DragConstraint &constraint, const Camera &camera, Place at) {
  if (constraint.kind == DragConstraint::Kind::Sphere)
    return at != constraint.center;
  if (constraint.direction == Place(0))
    return false;
  const Place sight = camera.orthographic ? camera.viewDirection() : glm::normalize(at - camera.eye());
  const bool onLine = constraint.kind == DragConstraint::Kind::Line;
  return sineOfAngle(constraint, sight) >= std::sin(onLine ? leastGrabAngle : leastPlaneGrabAngle);
}

std::optional<Place> dragged(const DragConstraint &constraint, const Camera &camera, PixelSize size,
                             Place start, glm::dvec2 pressed, glm::dvec2 now) {
  if (!isGrabbable(constraint, camera, start))
    return {};
  const std::optional<Place> before = placeUnder(pressed, constraint, camera, size, start);
  const std::optional<Place> after = placeUnder(now, constraint, camera, size, start);
  if (!before || !after)
    return {};
  return start + (*after - *before);
}

} // namespace halfspace
