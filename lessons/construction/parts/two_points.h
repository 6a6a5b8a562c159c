// What constructions of two points share: the way from the first to the second.
#pragma once

#include "lessons/construction/parts/own_names.h"
#include "lessons/construction/working.h"
#include "lessons/object/kinds/point.h"

namespace halfspace {

/// The In of such a construction.
struct TwoPoints : Naming {
  Given<PointObject> A;
  Given<PointObject> B;
};

/// What its Out begins with. The way w is drawn as the mark `w` where it has a length.
struct WayBetweenPoints : Computed<TwoPoints> {
  explicit WayBetweenPoints(const TwoPoints &objects) : Computed(objects) {}

  ExactVec3 way = in.B.object.at - in.A.object.at;
  bool areApart = !isZero(way);

  Term A = termOf(in.A);
  Term B = termOf(in.B);
  Term w = drawnName(vectorLetter("w"), way);
};

/// w = B − A.
[[nodiscard]] WorkingLine wayLine(const WayBetweenPoints &at);

} // namespace halfspace
