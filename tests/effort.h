// How much the tests with random input try in this build.
#pragma once

#include <cstddef>
#include <vector>

namespace halfspace::test {

/// Whether each step is watched, by asserts or sanitizers, so that an input takes some fifty times as long.
#if defined(NDEBUG) && !defined(HALFSPACE_SANITIZE)
inline constexpr bool isWatched = false;
#else
inline constexpr bool isWatched = true;
#endif

/// So many inputs, or a fiftieth of them where each step is watched.
constexpr int effort(int inputs) { return isWatched ? (inputs + 49) / 50 : inputs; }

/// How often something comes up at least among so many inputs: once, where each step is watched and few are
/// tried.
constexpr int atLeast(int count) { return isWatched ? 1 : count; }

/// All of these, or the first and every eighth behind it where each step is watched.
template <class Each> std::vector<Each> fewer(const std::vector<Each> &all) {
  std::vector<Each> some;
  for (std::size_t i = 0; i < all.size(); i += isWatched ? 8 : 1)
    some.push_back(all[i]);
  return some;
}

} // namespace halfspace::test
