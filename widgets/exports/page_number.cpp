#include "widgets/exports/page_number.h"

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

/// No page is larger; what is beyond it is not seen.
constexpr double farthest = 1e6;

} // namespace

std::string pageNumber(double value) {
  const long long parts = std::llround(std::clamp(value, -farthest, farthest) * writtenPerPoint);
  const long long size = std::abs(parts);
  std::string text = (parts < 0 ? "-" : "") + std::to_string(size / writtenPerPoint);
  if (size % writtenPerPoint != 0) {
    text += '.';
    text += static_cast<char>('0' + size % writtenPerPoint / 10);
    if (size % 10 != 0)
      text += static_cast<char>('0' + size % 10);
  }
  return text;
}

std::string pageNumbers(glm::dvec2 spot, const char *between) {
  return pageNumber(spot.x) + between + pageNumber(spot.y);
}

} // namespace halfspace
