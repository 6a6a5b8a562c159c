#include "lessons/figure/figure.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace halfspace {
namespace {

void draw(PlanePatchMark &patch, const Place &upTo) { patch.covers.push_back(upTo); }

void draw(LineMark &line, const Place &upTo) { line.covers.push_back(upTo); }

void draw(RayMark &ray, const Place &upTo) {
  if (!ray.meets || glm::distance(ray.origin, upTo) > glm::distance(ray.origin, *ray.meets))
    ray.meets = upTo;
}

/// All others end where they end.
template <class Other> void draw(Other &, const Place &) {}

bool hasNoEnd(const Mark &mark) {
  return std::holds_alternative<PlanePatchMark>(mark) || std::holds_alternative<RayMark>(mark) ||
         std::holds_alternative<LineMark>(mark);
}

bool hasNumbers(const Mark &mark) {
  return !baseOf(mark).numbers.empty() || !baseOf(mark).coordinates.empty();
}

} // namespace

void Figure::reachWithin(const std::string &plane, const std::string &ray, const Place &origin,
                         const Place &along) {
  reaches.push_back({ray, origin + (openRayLength - beyondHit) * along});
  reaches.push_back({plane, origin});
  reaches.push_back({plane, origin + openRayLength * along});
}

Figure reaching(Figure figure) {
  std::unordered_map<std::string_view, std::vector<Place>> byMark;
  for (const Reach &reach : figure.reaches)
    byMark[reach.mark].push_back(reach.at);
  for (std::size_t place = 0; place < figure.marks.size() && !byMark.empty(); ++place) {
    if (!hasNoEnd(figure.marks[place]))
      continue;
    const auto reached = byMark.extract(baseOf(figure.marks[place]).id); // of two with one id the first
    if (!reached.empty())
      figure.marks.change(place, [&](Mark &mark) {
        for (const Place &at : reached.mapped())
          std::visit([&](auto &each) { draw(each, at); }, mark);
      });
  }
  figure.reaches.clear();
  return figure;
}

void clearNumbers(Mark &mark) {
  baseOf(mark).numbers.clear();
  baseOf(mark).coordinates.clear();
}

void writeCoordinates(Mark &mark) {
  MarkBase &base = baseOf(mark);
  if (!base.label.empty())
    base.numbers = std::exchange(base.coordinates, {}) + base.numbers;
}

Figure withoutNumbers(Figure figure) {
  for (std::size_t place = 0; place < figure.marks.size(); ++place)
    if (hasNumbers(figure.marks[place]))
      figure.marks.change(place, [](Mark &mark) { clearNumbers(mark); });
  return figure;
}

} // namespace halfspace
