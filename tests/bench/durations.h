// Lists of measured times, in milliseconds.
#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

namespace halfspace::bench {

using Clock = std::chrono::steady_clock;

[[nodiscard]] inline double milliseconds(std::chrono::nanoseconds duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}
[[nodiscard]] inline double millisecondsSince(Clock::time_point start) {
  return milliseconds(Clock::now() - start);
}

struct Durations {
  std::vector<double> all;

  void add(double duration) { all.push_back(duration); }
  /// The duration that this part of all do not exceed; 0 of none.
  [[nodiscard]] double quantile(double part) const {
    if (all.empty())
      return 0;
    std::vector<double> sorted = all;
    std::sort(sorted.begin(), sorted.end());
    return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1) + 0.5)];
  }
  [[nodiscard]] double median() const { return quantile(0.5); }
};

} // namespace halfspace::bench
