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
