// What constructions of two vectors share: both are seen from one point, they span a parallelogram, and one
// can be turned until it lies along the other or across it.
#pragma once

#include "lessons/construction/special_case.h"
#include "lessons/figure/figure.h"
#include "lessons/object/kinds/vector.h"

#include <string>
#include <vector>

namespace halfspace {

/// Draws a vector once more from where another starts, unless it starts there: it is the same vector. The
/// mark accompanies `leader`.
void drawMoved(Figure &figure, const std::string &leader, const Place &from,
               const Given<VectorObject> &moved);

/// The parallelogram of two vectors from a point. `area` comes to how large it is, and stands in it as its
/// label.
[[nodiscard]] PolygonMark parallelogramOf(std::string id, const Term &area, const Place &from,
                                          const Place &first, const Place &second);

/// The height over u, from the tip of v to the line of u, both drawn from a point. Where its foot lies beside
/// u, the line is drawn up to there. Requires that u ≠ 0.
void addHeight(Figure &figure, const Term &height, const Place &from, const ExactVec3 &u, const ExactVec3 &v);

/// What holds when the second of two vectors is across the first, and when it lies along it.
struct TurnedConditions {
  Conditions perpendicular;
  Conditions onOneLine;
};
/// The second vector, in `role`, turned to the nearest of both. Nothing where one of them is there already or
/// is zero.
[[nodiscard]] std::vector<SpecialCase> turnedNearby(const Given<VectorObject> &first,
                                                    const Given<VectorObject> &second,
                                                    const std::string &role, TurnedConditions conditions);

} // namespace halfspace
