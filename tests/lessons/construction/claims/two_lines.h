// Two lines, as several constructions look at them.
#pragma once

#include "lessons/object/kinds/line.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

namespace halfspace::test {

struct TwoLines {
  explicit TwoLines(Objects objects)
      : g(objectAs<LineObject>(*objects[0]).value()), h(objectAs<LineObject>(*objects[1]).value()),
        common(perpendicular(g.direction, h.direction)), way(h.point - g.point),
        turn(determinant(g.direction, way, h.direction)) {}

  bool areLines() const { return !vanishes(g.direction) && !vanishes(h.direction); }
  bool areAlong() const { return areLines() && vanishes(common); }
  bool areSame() const { return areAlong() && vanishes(perpendicular(way, g.direction)); }
  bool areParallel() const { return areAlong() && !areSame(); }
  /// The directions are no multiples of each other.
  bool areAcross() const { return areLines() && !vanishes(common); }
  bool meet() const { return areAcross() && turn == 0; }
  bool areSkew() const { return areAcross() && turn != 0; }

  LineObject g, h;
  ExactVec3 common;
  ExactVec3 way;
  /// How the second line turns around the first, seen with the first one's direction pointing at you: the
  /// way to it and its direction turn as the hands of a clock do where this is negative.
  Rational turn;
};

inline bool areLines(const TwoLines &at) { return at.areLines(); }
inline bool areAlong(const TwoLines &at) { return at.areAlong(); }
inline bool areAcross(const TwoLines &at) { return at.areAcross(); }
inline bool areSame(const TwoLines &at) { return at.areSame(); }
inline bool areParallel(const TwoLines &at) { return at.areParallel(); }
inline bool meet(const TwoLines &at) { return at.meet(); }
inline bool areSkew(const TwoLines &at) { return at.areSkew(); }

/// Of the case of lines without a direction.
[[nodiscard]] inline Claims zeroLinesClaims() {
  return claimsAbout<TwoLines>({
      {"{g.v} and {h.v} are zero vectors: they point nowhere, so there are no lines.",
       [](const TwoLines &at) { return vanishes(at.g.direction) && vanishes(at.h.direction); }},
      {"{g.v} is the zero vector: it points nowhere, so {g} is no line.",
       [](const TwoLines &at) { return vanishes(at.g.direction) && !vanishes(at.h.direction); }},
      {"{h.v} is the zero vector: it points nowhere, so {h} is no line.",
       [](const TwoLines &at) { return !vanishes(at.g.direction) && vanishes(at.h.direction); }},
  });
}

} // namespace halfspace::test
