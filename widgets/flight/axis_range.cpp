#include "widgets/flight/axis_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace halfspace {
namespace {

constexpr AxisRange smallest;
/// Of what it has to hold, on both sides.
constexpr double margin = 0.08;
/// Hits beyond so many times the way to the nearest, or to the end of the smallest range, are left out.
constexpr double farthest = 6;
/// Behind the start so much of the way ahead is shown at the most.
constexpr double longestBehind = 0.5;
/// The range ends at whole multiples of a step; it has about so many.
constexpr double stepsInRange = 8;

/// The least of 1, 2, 5 times a power of ten that is not below a positive number.
Rational niceStep(double least) {
  const int power = static_cast<int>(std::floor(std::log10(least)));
  for (const int factor : {1, 2, 5})
    if (const Rational step = factor * powerOfTen(power); toDouble(step) >= least)
      return step;
  return powerOfTen(power + 1);
}

AxisRange roundedOutward(const AxisRange &range) {
  const double step = toDouble(niceStep((range.high - range.low) / stepsInRange));
  return {std::floor(range.low / step) * step, std::ceil(range.high / step) * step};
}

} // namespace

AxisRange rangeFor(const std::vector<double> &hits, double t) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const double hit : hits)
    if (hit >= 0)
      nearest = std::min(nearest, hit);
  double reach = smallest.high;
  if (std::isfinite(nearest))
    reach = std::max(reach, nearest);
  AxisRange held{std::min(0.0, t), std::max(0.0, t)};
  for (const double hit : hits)
    if (hit >= 0 && hit <= farthest * reach)
      held.high = std::max(held.high, hit);
  for (const double hit : hits)
    if (hit < 0 && -hit <= longestBehind * std::max(held.high, smallest.high))
      held.low = std::min(held.low, hit);
  const double room = margin * (held.high - held.low);
  const AxisRange wanted{held.low < 0 ? held.low - room : 0, held.high + room};
  if (wanted.low >= smallest.low && wanted.high <= smallest.high)
    return smallest;
  return roundedOutward({std::min(wanted.low, smallest.low), std::max(wanted.high, smallest.high)});
}

double AxisScale::xOf(double t) const {
  return left + (t - range.low) / (range.high - range.low) * (right - left);
}

double AxisScale::tAt(double x) const {
  return range.low + (x - left) / (right - left) * (range.high - range.low);
}

AxisTicks ticksOf(const AxisScale &scale, double gap) {
  const double span = scale.range.high - scale.range.low;
  AxisTicks ticks;
  ticks.step = niceStep(span * std::min(1.0, gap / std::max(1.0, scale.right - scale.left)));
  const double step = toDouble(ticks.step);
  const double slack = step * 1e-6; // a range that ends at a tick shows it
  const auto first = static_cast<std::int64_t>(std::ceil((scale.range.low - slack) / step));
  const auto last = static_cast<std::int64_t>(std::floor((scale.range.high + slack) / step));
  for (std::int64_t i = first; i <= last; ++i)
    ticks.at.push_back(ticks.step * Rational(i));
  return ticks;
}

} // namespace halfspace
