#include "app/panels/size_scale.h"

#include <QScreen>

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

/// Screens higher than this at the usual dot density are made for larger type and lines.
constexpr double usualScreenHeight = 1080;
/// From here on, in dots an inch, fonts are scaled already.
constexpr double highDensity = 120;

} // namespace

double usualSizeScale(const QScreen &screen) {
  if (screen.devicePixelRatio() != 1 || screen.logicalDotsPerInch() >= highDensity)
    return smallestSizeScale;
  const double wanted = screen.size().height() / usualScreenHeight;
  return std::clamp(std::floor(wanted / sizeScaleStep) * sizeScaleStep, smallestSizeScale, largestSizeScale);
}

} // namespace halfspace
