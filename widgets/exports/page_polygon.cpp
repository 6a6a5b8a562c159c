#include "widgets/exports/page_polygon.h"

#include <glm/common.hpp>

#include <algorithm>
#include <utility>

namespace halfspace {

std::vector<glm::dvec2> hullOf(std::vector<glm::dvec2> spots) {
  std::sort(spots.begin(), spots.end(),
            [](glm::dvec2 a, glm::dvec2 b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
  std::vector<glm::dvec2> hull;
  const auto goAround = [&](auto first, auto last) {
    const std::size_t begin = hull.size();
    for (auto spot = first; spot != last; ++spot) {
      while (hull.size() >= begin + 2 &&
             crossOf(hull.back() - hull[hull.size() - 2], *spot - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(*spot);
    }
    hull.pop_back(); // where the other side begins
  };
  if (spots.size() < 3)
    return spots;
  goAround(spots.begin(), spots.end());
  goAround(spots.rbegin(), spots.rend());
  return hull;
}

double turningArea(const std::vector<glm::dvec2> &corners) {
  double area = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    area += crossOf(corners[i], corners[(i + 1) % corners.size()]);
  return area;
}

PixelBox boxAround(const std::vector<glm::dvec2> &spots) {
  PixelBox box{spots.front(), spots.front()};
  for (const glm::dvec2 &spot : spots)
    box = {glm::min(box.low, spot), glm::max(box.high, spot)};
  return box;
}

bool meet(const PixelBox &a, const PixelBox &b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

} // namespace halfspace
