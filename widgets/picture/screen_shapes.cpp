#include "widgets/picture/screen_shapes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace halfspace {

namespace {

double partOfSegment(glm::dvec2 pixel, glm::dvec2 from, glm::dvec2 to) {
  const glm::dvec2 along = to - from;
  const double square = glm::dot(along, along);
  return square > 0 ? std::clamp(glm::dot(pixel - from, along) / square, 0.0, 1.0) : 0;
}

/// Twice the area of the triangle from a segment to a pixel, positive on one side of it.
double sideOf(glm::dvec2 from, glm::dvec2 to, glm::dvec2 pixel) {
  const glm::dvec2 along = to - from;
  const glm::dvec2 way = pixel - from;
  return along.x * way.y - along.y * way.x;
}

} // namespace

double distanceToSegment(glm::dvec2 pixel, glm::dvec2 from, glm::dvec2 to) {
  return glm::distance(pixel, glm::mix(from, to, partOfSegment(pixel, from, to)));
}

double partNearest(const Stroke &stroke, glm::dvec2 pixel) {
  return partOfSegment(pixel, stroke.from, stroke.to);
}

double distanceTo(const Stroke &stroke, glm::dvec2 pixel) {
  const double part = partNearest(stroke, pixel);
  return glm::distance(pixel, glm::mix(stroke.from, stroke.to, part)) -
         std::lerp(stroke.fromRadius, stroke.toRadius, part);
}

double overlapArea(const PixelBox &a, const PixelBox &b) {
  const glm::dvec2 common = glm::min(a.high, b.high) - glm::max(a.low, b.low);
  return std::max(0.0, common.x) * std::max(0.0, common.y);
}

double distanceTo(const PixelBox &box, glm::dvec2 pixel) {
  return glm::distance(pixel, glm::clamp(pixel, box.low, box.high));
}

double distanceTo(const PixelBox &box, glm::dvec2 from, glm::dvec2 to) {
  if (lengthInside(box, from, to) > 0)
    return 0;
  double least = std::min(distanceTo(box, from), distanceTo(box, to));
  for (const glm::dvec2 corner : {box.low, box.high, {box.low.x, box.high.y}, {box.high.x, box.low.y}})
    least = std::min(least, distanceToSegment(corner, from, to));
  return least;
}

bool doCross(glm::dvec2 from, glm::dvec2 to, glm::dvec2 otherFrom, glm::dvec2 otherTo) {
  return sideOf(from, to, otherFrom) * sideOf(from, to, otherTo) < 0 &&
         sideOf(otherFrom, otherTo, from) * sideOf(otherFrom, otherTo, to) < 0;
}

double lengthInside(const PixelBox &box, glm::dvec2 from, glm::dvec2 to) {
  const glm::dvec2 low = glm::min(from, to);
  const glm::dvec2 high = glm::max(from, to);
  if (high.x < box.low.x || high.y < box.low.y || low.x > box.high.x || low.y > box.high.y)
    return 0;
  const glm::dvec2 along = to - from;
  double enter = 0;
  double leave = 1;
  for (int axis = 0; axis < 2; ++axis) {
    if (along[axis] == 0)
      continue;
    const double a = (box.low[axis] - from[axis]) / along[axis];
    const double b = (box.high[axis] - from[axis]) / along[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return std::max(0.0, leave - enter) * glm::length(along);
}

bool isInside(glm::dvec2 pixel, const std::vector<glm::dvec2> &corners) {
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec2 a = corners[i];
    const glm::dvec2 b = corners[(i + 1) % corners.size()];
    const bool crossesRow = (a.y > pixel.y) != (b.y > pixel.y);
    if (crossesRow && pixel.x < a.x + (b.x - a.x) * (pixel.y - a.y) / (b.y - a.y))
      inside = !inside;
  }
  return inside;
}

std::optional<std::vector<glm::dvec3>> projectAll(const Camera &camera, PixelSize size,
                                                  const std::vector<Place> &places) {
  std::vector<glm::dvec3> pixels;
  for (const Place &place : places) {
    const std::optional<glm::dvec3> pixel = camera.project(place, size);
    if (!pixel)
      return {};
    pixels.push_back(*pixel);
  }
  return pixels;
}

} // namespace halfspace
