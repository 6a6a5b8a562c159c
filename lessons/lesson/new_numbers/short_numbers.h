// New numbers for a scene, short enough to work with by hand.
#pragma once

#include "lessons/scene/scene.h"

#include <cstdint>
#include <functional>

namespace halfspace {

/// What new numbers are to be like.
struct WantedNumbers {
  bool keepCase = true;                       ///< false: any case will do, but no degenerate one
  std::function<bool(const Scene &)> suits{}; ///< whether a scene can be shown; empty: every one
};

/// The scene with other coordinates: whole numbers of one digit, chosen so that the last construction's case
/// stays what it was if that is wanted, and so that its results are short. It has the same lines too, where
/// chance allows: what a lesson says of them goes on to hold. What meets does so at whole points, and normals
/// are as long as whole numbers say. A degenerate scene becomes an ordinary one; but a triangle with its
/// corners on one line has them on one line again: where the case is to be kept two times in three, so that
/// not every result is 0, and always where it need not be. The same seed gives the same numbers
/// everywhere.
///
/// A scene whose constructions allow nothing of that kind keeps its numbers.
[[nodiscard]] Scene withShortNumbers(Scene scene, std::uint64_t seed, const WantedNumbers &wanted = {});

/// The work is bounded by this many evaluations of the last construction and what it follows from.
inline constexpr int mostNumbersTried = 200;

} // namespace halfspace
