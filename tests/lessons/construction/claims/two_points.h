// What several constructions say of two points.
#pragma once

#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/two_points.h"

namespace halfspace::test {

inline bool areSame(const PointPair &at) { return at.areSame(); }
inline bool areApart(const PointPair &at) { return !at.areSame(); }

/// Of the way from the first to the second.
[[nodiscard]] inline Claims wayClaims() {
  return claimsAbout<PointPair>({
      {"From {A} to {B}.", areApart},
      {"The zero vector: {A} and {B} are the same point.", areSame},
  });
}

} // namespace halfspace::test
