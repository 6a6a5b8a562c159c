#include "lessons/construction/parts/shifted_ray.h"

#include "geometry/project_vector.h"

#include <optional>

namespace halfspace {
namespace {

/// The shortest way by which the ray is to be moved for its line to meet the line of a segment, where it then
/// meets it between the ends; nothing where it would not, or where the two are parallel.
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

void add(const RayObject &ray, const ExactVec3 &shift, Conditions when, std::string sentence,
         std::vector<SpecialCase> &all) {
  if (!isZero(shift))
    all.push_back({std::move(when), std::move(sentence), "L", RayObject{ray.origin + shift, ray.direction}});
}

} // namespace

void addRayThrough(const RayObject &ray, const ExactVec3 &point, Conditions when, std::string sentence,
                   std::vector<SpecialCase> &all) {
  add(ray, projectVector(ExactVec3(point - ray.origin), ray.direction).rejection, std::move(when),
      std::move(sentence), all);
}

void addRayThrough(const RayObject &ray, const std::pair<ExactVec3, ExactVec3> &segment, Conditions when,
                   std::string sentence, std::vector<SpecialCase> &all) {
  if (const auto shift = shiftOntoSegment(ray, segment.first, segment.second))
    add(ray, *shift, std::move(when), std::move(sentence), all);
}

} // namespace halfspace
