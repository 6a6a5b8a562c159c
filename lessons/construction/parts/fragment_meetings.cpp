#include "lessons/construction/parts/fragment_meetings.h"

#include "geometry/barycentric.h"

#include <algorithm>
#include <set>

namespace halfspace {
namespace {

/// Along the ray each corner's weight changes evenly, and those of inside are never negative: each weight
/// leaves a piece of the ray. Nothing where no piece is left.
std::optional<Passage> passageThrough(const RayObject &ray, const Triangle<Rational> &triangle) {
  const auto atStart = barycentricOf(ray.origin, triangle).weights;
  const auto stepLater = barycentricOf(ExactVec3(ray.origin + ray.direction), triangle).weights;
  Rational begin;
  std::optional<Rational> end;
  for (std::size_t i = 0; i < atStart.size(); ++i) {
    const Rational slope = stepLater[i] - atStart[i];
    if (slope == 0 && atStart[i] < 0)
      return {};
    if (slope == 0)
      continue;
    const Rational zero = -atStart[i] / slope;
    if (slope > 0)
      begin = std::max(begin, zero);
    else
      end = end ? std::min(*end, zero) : zero;
  }
  // The weights add up to 1, so one of them falls along the ray.
  return end && begin <= *end ? std::optional(Passage{begin, *end}) : std::nullopt;
}

} // namespace

Placements placementsOf(const GivenMeshes &meshes) {
  Placements placements;
  for (const auto &mesh : meshes)
    placements.emplace_back(mesh.object);
  return placements;
}

Meeting meetingWith(const RayObject &ray, const GivenMeshes &meshes, const Placements &placements,
                    std::size_t number) {
  const Fragment fragment = fragmentOf(meshes, number);
  const auto own = meshes[fragment.mesh].object.shape->mesh()->triangle(fragment.index);
  const Triangle<Rational> triangle = placements[fragment.mesh].toScene(own);
  return {fragment, number, triangle,
          intersectRayTriangle(Ray<Rational>{ray.origin, ray.direction}, triangle)};
}

bool isNearer(const Meeting &a, const Meeting &b) {
  return a.meet.plane.t != b.meet.plane.t ? a.meet.plane.t < b.meet.plane.t : a.number < b.number;
}

std::vector<Meeting> listedMeetings(const RayObject &ray, const GivenMeshes &meshes,
                                    const Placements &placements,
                                    const std::vector<std::optional<Meeting>> &needed) {
  std::set<std::size_t> numbers;
  std::size_t before = 0;
  for (const auto &mesh : meshes) {
    const std::size_t count = mesh.object.shape->triangleCount();
    if (numbers.size() + count <= mostListedFragments)
      for (std::size_t number = before + 1; number <= before + count; ++number)
        numbers.insert(number);
    before += count;
  }
  for (const auto &each : needed)
    if (each)
      numbers.insert(each->number);
  std::vector<Meeting> listed;
  listed.reserve(numbers.size());
  for (const std::size_t number : numbers)
    listed.push_back(meetingWith(ray, meshes, placements, number));
  return listed;
}

std::optional<Passage> firstAlong(const RayObject &ray, const std::vector<Meeting> &meetings) {
  std::optional<Passage> first;
  for (const Meeting &meeting : meetings) {
    if (meeting.meet.which != RayTriangleCase::InPlane)
      continue;
    auto passage = passageThrough(ray, meeting.triangle);
    if (passage && (!first || passage->begin < first->begin)) {
      passage->fragment = meeting.fragment;
      first = passage;
    }
  }
  return first;
}

} // namespace halfspace
