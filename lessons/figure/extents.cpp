#include "lessons/figure/extents.h"

#include <cmath>

namespace halfspace {
namespace {

Extent mixed(const Extent &from, const Extent &to, double part) {
  return {std::lerp(from.low, to.low, part), std::lerp(from.high, to.high, part)};
}

} // namespace

Extents extentsOf(const Figure &figure) {
  Extents extents;
  for (const Mark &mark : figure.marks)
    std::visit(Overloaded{[&](const PlanePatchMark &patch) { extents[patch.id] = extentOf(patch); },
                          [&](const RayMark &ray) { extents[ray.id].first = extentOf(ray); },
                          [&](const LineMark &line) { extents[line.id].first = extentOf(line); },
                          [](const auto &) {}},
               mark);
  return extents;
}

Figure heldAt(Figure figure, const Extents &extents) {
  for (std::size_t place = 0; place < figure.marks.size(); ++place)
    if (const auto held = extents.find(baseOf(figure.marks[place]).id); held != extents.end())
      figure.marks.change(place, [&](Mark &mark) {
        std::visit(Overloaded{[&](PlanePatchMark &patch) { patch.held = held->second; },
                              [&](RayMark &ray) { ray.held = held->second.first; },
                              [&](LineMark &line) { line.held = held->second.first; }, [](auto &) {}},
                   mark);
      });
  return figure;
}

Extents between(const Extents &from, const Extents &to, double part) {
  Extents extents;
  for (const auto &[id, start] : from)
    if (const auto end = to.find(id); end != to.end())
      extents[id] = {mixed(start.first, end->second.first, part),
                     mixed(start.second, end->second.second, part)};
  return extents;
}

} // namespace halfspace
