#include "lessons/figure/figure.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <unordered_map>

namespace halfspace {
namespace {

void draw(PlanePatchMark &patch, const Place &upTo) { patch.covers.push_back(upTo); }

void draw(LineMark &line, const Place &upTo) { line.covers.push_back(upTo); }

void draw(RayMark &ray, const Place &upTo) {
  if (!ray.meets || glm::distance(ray.origin, upTo) > glm::distance(ray.origin, *ray.meets))
    ray.meets = upTo;
}

} // namespace

void Figure::reachWithin(const std::string &plane, const std::string &ray, const Place &origin,
                         const Place &along) {
  reaches.push_back({ray, origin + (openRayLength - beyondHit) * along});
  reaches.push_back({plane, origin});
  reaches.push_back({plane, origin + openRayLength * along});
}

Figure reaching(Figure figure) {
  std::unordered_map<std::string_view, Mark *> byId;
  for (Mark &mark : figure.marks)
    byId.emplace(baseOf(mark).id, &mark);
  for (const Reach &reach : figure.reaches)
    if (const auto found = byId.find(reach.mark); found != byId.end())
      std::visit(Overloaded{[&](PlanePatchMark &patch) { draw(patch, reach.at); },
                            [&](RayMark &ray) { draw(ray, reach.at); },
                            [&](LineMark &line) { draw(line, reach.at); }, [](auto &) {}},
                 *found->second);
  figure.reaches.clear();
  return figure;
}

Figure withoutNumbers(Figure figure) {
  for (Mark &mark : figure.marks)
    baseOf(mark).numbers.clear();
  return figure;
}

} // namespace halfspace
