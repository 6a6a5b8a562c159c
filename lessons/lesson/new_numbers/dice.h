// Chance that is the same everywhere for the same seed, and the whole numbers that new coordinates are made
// of.
#pragma once

#include "lessons/object/object.h"

#include <array>
#include <cstdint>
#include <random>

namespace halfspace {

/// No new coordinate is larger, either way.
inline constexpr int largestShortNumber = 9;
/// Of a direction that does not follow from others.
inline constexpr int longestStep = 3;
/// A triangle's sides are so many times a short vector.
inline constexpr int smallestTriangle = 3;
inline constexpr int largestTriangle = 4;
/// No coordinate of a side is longer: their products of four are still to be calculated.
inline constexpr int longestSide = 6;

/// One roll in a statement, or several in braces: elsewhere C++ leaves their order to the compiler, and a
/// seed would not give the same numbers everywhere.
class Dice {
public:
  explicit Dice(std::uint64_t seed) : m_engine(seed) {}

  /// Whole, from low to high. (What the standard library does for this differs between libraries.)
  int between(int low, int high);
  /// True once in `times`.
  bool once(int times) { return between(1, times) == 1; }
  int sign() { return once(2) ? -1 : 1; }

  /// A position that does not follow from others: small, and mostly where the axes are drawn.
  ExactVec3 position();
  /// At most one of its coordinates is 0, and none is longer.
  ExactVec3 direction(int longest);
  /// As long as a whole number says.
  ExactVec3 normal();
  /// 3 long.
  ExactVec3 shortestNormal();
  /// 3 or 5 long.
  ExactVec3 shortNormal();

private:
  /// The numbers in any order, with any signs.
  ExactVec3 turned(std::array<int, 3> numbers);

  std::mt19937_64 m_engine;
};

} // namespace halfspace
