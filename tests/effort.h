// How much the tests with random input try in this build.
#pragma once

namespace halfspace::test {

/// Whether each step is watched, by asserts or sanitizers, so that an input takes ten times as long.
#if defined(NDEBUG) && !defined(HALFSPACE_SANITIZE)
inline constexpr bool isWatched = false;
#else
inline constexpr bool isWatched = true;
#endif

/// So many inputs, or a tenth of them where each step is watched.
constexpr int effort(int inputs) { return isWatched ? (inputs + 9) / 10 : inputs; }

} // namespace halfspace::test
