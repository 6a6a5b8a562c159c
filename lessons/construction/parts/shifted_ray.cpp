#include "lessons/construction/parts/shifted_ray.h"

#include "geometry/project_vector.h"

namespace halfspace {

std::optional<ExactVec3> shiftOntoSegment(const RayObject &ray, const ExactVec3 &from, const ExactVec3 &to) {
  const ExactVec3 along = to - from;
  const ExactVec3 across = cross(ray.direction, along); // to both: the shortest way goes along it
  if (isZero(across))
    return {};
  const ExactVec3 way = from - ray.origin;
  // The segment's line as seen along the ray: from + share·along lies on the moved ray's line.
  const Rational share = dot(cross(ray.direction, way), across) / -dot(across, across);
  if (share <= 0 || share >= 1)
    return {};
  return projectVector(way, across).projection;
}

} // namespace halfspace
