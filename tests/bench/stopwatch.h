// Times of things that are done many times over, compared within one run.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace halfspace::bench {

/// Something to be measured; it returns a number that depends on all its work, so that none is left out.
struct Contender {
  std::string name;
  std::size_t things; ///< that one round of work does
  std::function<double()> work;
  double nanoseconds = 0; ///< set by `race`: for one thing, in the quickest round
};

inline double nanosecondsOf(const std::function<double()> &work) {
  static volatile double sink = 0;
  const auto start = std::chrono::steady_clock::now();
  sink = sink + work();
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
}

/// Lets all work in turns, so that what disturbs one disturbs each: the quickest round is the one least
/// disturbed.
inline void race(std::vector<Contender> &contenders, int rounds) {
  for (Contender &contender : contenders)
    contender.nanoseconds = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds; ++round)
    for (Contender &contender : contenders)
      contender.nanoseconds =
          std::min(contender.nanoseconds, nanosecondsOf(contender.work) / double(contender.things));
}

/// Prints each one's time and its ratio to the first one's.
inline void print(const char *title, const std::vector<Contender> &contenders) {
  std::printf("\n%-44s %10s %10s\n", title, "ns", "ratio");
  for (const Contender &each : contenders)
    std::printf("  %-42s %10.2f %10.2f\n", each.name.c_str(), each.nanoseconds,
                each.nanoseconds / contenders.front().nanoseconds);
}

inline void printRatio(const std::string &what, double ratio, bool isMet) {
  std::printf("  %-60s %8.2f  %s\n", what.c_str(), ratio, isMet ? "met" : "missed");
}

/// Whether the ratio is at most so large.
inline void printGoal(const std::string &what, double ratio, double goal) {
  printRatio(what + ", goal " + std::to_string(goal).substr(0, 4), ratio, ratio <= goal);
}

/// Whether it is at least so large.
inline void printLeast(const std::string &what, double ratio, double least) {
  printRatio(what + ", at least " + std::to_string(least).substr(0, 4), ratio, ratio >= least);
}

} // namespace halfspace::bench
