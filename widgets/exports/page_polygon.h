// Polygons on a page, and boxes around them; lengths are in points.
#pragma once

#include "widgets/picture/camera.h"

namespace halfspace {

/// By how much `b` turns from `a`: positive from x to y. Twice the area of the triangle that they span.
[[nodiscard]] inline double crossOf(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

/// The polygon around all spots, turning like the axes of the page from x to y; fewer than three corners
/// where they lie along one line.
[[nodiscard]] std::vector<glm::dvec2> hullOf(std::vector<glm::dvec2> spots);

/// Twice the area of a polygon; negative where it turns the other way than the axes of the page from x to y.
[[nodiscard]] double turningArea(const std::vector<glm::dvec2> &corners);

/// The least box around spots, of which there is one at least.
[[nodiscard]] PixelBox boxAround(const std::vector<glm::dvec2> &spots);

/// Whether two boxes have a spot in common, be it on their borders.
[[nodiscard]] bool meet(const PixelBox &a, const PixelBox &b);

} // namespace halfspace
