// Corners of a polygon as tests look at them: whether they lie in a plane, and whether their boundary meets
// itself, by the parameters of its sides in space.
#pragma once

#include "tests/lessons/construction/expected/recompute_tools.h"

namespace halfspace::test {

using CornerList = std::vector<ExactVec3>;

inline bool areOnOneLine(const CornerList &corners) {
  for (const ExactVec3 &a : corners)
    for (const ExactVec3 &b : corners)
      if (!vanishes(perpendicular(ExactVec3(a - corners[0]), ExactVec3(b - corners[0]))))
        return false;
  return true;
}

inline bool areInOnePlane(const CornerList &corners) {
  for (const ExactVec3 &a : corners)
    for (const ExactVec3 &b : corners)
      for (const ExactVec3 &c : corners)
        if (determinant(a - corners[0], b - corners[0], c - corners[0]) != 0)
          return false;
  return true;
}

/// Whether two segments of a plane meet: from P along u, and from Q along v.
inline bool meet(const ExactVec3 &P, const ExactVec3 &u, const ExactVec3 &Q, const ExactVec3 &v) {
  const ExactVec3 way = Q - P;
  const ExactVec3 n = perpendicular(u, v);
  const auto isShare = [](const Rational &share) { return share >= 0 && share <= 1; };
  if (!vanishes(n))
    return isShare(product(perpendicular(way, v), n) / product(n, n)) &&
           isShare(product(perpendicular(way, u), n) / product(n, n));
  if (!vanishes(perpendicular(way, u)))
    return false;
  // On one line: an end of one is between those of the other.
  const Rational begin = product(way, u) / product(u, u);
  const Rational end = product(ExactVec3(way + v), u) / product(u, u);
  return isShare(begin) || isShare(end) || (begin < 0) != (end < 0);
}

/// Of corners in a plane, not on one line.
inline bool doesBoundaryMeetItself(const CornerList &given) {
  CornerList corners;
  for (std::size_t i = 0; i < given.size(); ++i)
    if (given[i] != given[(i + 1) % given.size()])
      corners.push_back(given[i]);
  const std::size_t count = corners.size();
  const auto side = [&](std::size_t i) { return ExactVec3(corners[(i + 1) % count] - corners[i % count]); };
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const bool follows = i == k + 1;
      const bool leads = k == 0 && i + 1 == count;
      if (!follows && !leads && meet(corners[i], side(i), corners[k], side(k)))
        return true;
      const ExactVec3 before = follows ? side(k) : side(i);
      const ExactVec3 after = follows ? side(i) : side(k);
      if ((follows || leads) && vanishes(perpendicular(before, after)) && product(before, after) < 0)
        return true;
    }
  return false;
}

} // namespace halfspace::test
