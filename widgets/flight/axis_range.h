// What part of the ray's parameter an axis shows, and where.
#pragma once

#include "geometry/rational.h"

#include <vector>

namespace halfspace {

struct AxisRange {
  double low = -0.5;
  double high = 2;
  [[nodiscard]] bool contains(double t) const { return low <= t && t <= high; }
  bool operator==(const AxisRange &) const = default;
};

/// Some room around the hits and the present t, up to whole ticks, so that it seldom changes; at least −0.5
/// to 2. Hits that lie many times as far as the nearest are left out: else that would not be seen.
/// (1) It contains t and the nearest of the hits with t ≥ 0.
/// Requires finite numbers; hits in any order.
[[nodiscard]] AxisRange rangeFor(const std::vector<double> &hits, double t);

/// A range on a line of pixels.
struct AxisScale {
  AxisRange range;
  double left = 0;
  double right = 1;

  /// (1) tAt(xOf(t)) = t, but for rounding.
  /// (2) xOf(t) < xOf(u) for t < u.
  [[nodiscard]] double xOf(double t) const;
  [[nodiscard]] double tAt(double x) const;
};

/// The ticks of a range are the whole multiples of a step: 1, 2 or 5 times a power of ten.
/// (1) They are at least `gap` pixels apart, and not 2.5 times as far as that requires.
/// (2) All lie in the range.
struct AxisTicks {
  Rational step = 1;
  std::vector<Rational> at;
};
[[nodiscard]] AxisTicks ticksOf(const AxisScale &scale, double gap);

} // namespace halfspace
