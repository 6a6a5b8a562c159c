// Distances on the screen, in pixels.
#pragma once

#include "widgets/picture/camera.h"

namespace halfspace {

/// From a pixel to the nearest point of the segment between two others.
[[nodiscard]] double distanceToSegment(glm::dvec2 pixel, glm::dvec2 from, glm::dvec2 to);

/// The area that two boxes have in common.
[[nodiscard]] double overlapArea(const PixelBox &a, const PixelBox &b);

/// From a pixel to the nearest of a box; 0 inside.
[[nodiscard]] double distanceTo(const PixelBox &box, glm::dvec2 pixel);

/// From a segment between two pixels to the nearest of a box; 0 where it goes through.
[[nodiscard]] double distanceTo(const PixelBox &box, glm::dvec2 from, glm::dvec2 to);

/// Whether two segments cross, each going from one side of the other to its other side.
[[nodiscard]] bool doCross(glm::dvec2 from, glm::dvec2 to, glm::dvec2 otherFrom, glm::dvec2 otherTo);

/// The length of the part of a segment that lies in a box.
[[nodiscard]] double lengthInside(const PixelBox &box, glm::dvec2 from, glm::dvec2 to);

/// The box with a margin around it, or within it where that is negative.
[[nodiscard]] inline PixelBox grown(const PixelBox &box, double margin) {
  return {box.low - margin, box.high + margin};
}
/// A thick line on the screen with round ends, each as thick as is said; a disc where both ends are one.
struct Stroke {
  glm::dvec2 from{};
  glm::dvec2 to{};
  double fromRadius = 0;
  double toRadius = 0;
  bool operator==(const Stroke &) const = default;
};

/// The part of the way along a stroke where it comes nearest to a pixel: 0 at its start, 1 at its end.
[[nodiscard]] double partNearest(const Stroke &stroke, glm::dvec2 pixel);
/// From a pixel to the edge of a stroke; negative within it.
[[nodiscard]] double distanceTo(const Stroke &stroke, glm::dvec2 pixel);

/// Whether a pixel lies in a polygon, whichever way round its corners go.
[[nodiscard]] bool isInside(glm::dvec2 pixel, const std::vector<glm::dvec2> &corners);

/// The pixels (and depths) of places; nothing when one of them is behind the eye.
[[nodiscard]] std::optional<std::vector<glm::dvec3>> projectAll(const Camera &camera, PixelSize size,
                                                                const std::vector<Place> &places);

} // namespace halfspace
