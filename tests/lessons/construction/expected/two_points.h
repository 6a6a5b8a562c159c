// Two points, as several constructions look at them.
#pragma once

#include "lessons/object/kinds/point.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {

struct PointPair {
  explicit PointPair(Objects objects)
      : A(objectAs<PointObject>(*objects[0])->at), B(objectAs<PointObject>(*objects[1])->at) {}

  [[nodiscard]] bool areSame() const { return A.x == B.x && A.y == B.y && A.z == B.z; }
  [[nodiscard]] ExactVec3 way() const { return {B.x - A.x, B.y - A.y, B.z - A.z}; }

  ExactVec3 A, B;
};

/// The case and the names of points and way.
[[nodiscard]] inline Recomputed recomputedPair(const PointPair &pair) {
  Recomputed expected;
  expected.caseName = pair.areSame() ? "same" : "apart";
  expected.names = {{"A", quantity(pair.A)}, {"B", quantity(pair.B)}, {"\\vec w", quantity(pair.way())}};
  if (pair.areSame())
    expected.vanished.insert("it.w");
  return expected;
}

/// B − A
inline void addWay(std::vector<WrongAnswer> &all, const PointPair &pair) {
  const ExactVec3 way = pair.way();
  addVector(all, "w", "reversed", ExactVec3(-way), way);
  addVector(all, "w", "added", ExactVec3(pair.A + pair.B), way);
  for (int i = 0; i < 3; ++i) {
    ExactVec3 wrong = way;
    wrong[i] = -way[i];
    addVector(all, "w", "one coordinate's difference reversed", wrong, way);
    wrong[i] = pair.A[i] + pair.B[i];
    addVector(all, "w", "one coordinate added", wrong, way);
  }
}

} // namespace halfspace::test
