// What stays of the three ways where there is nothing to divide by.
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/triangle.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

/// A line without statements where there is none with this id.
WorkingLine lineOf(const Object &triangle, const Object &ray, const char *id) {
  const Outcome outcome = lastOutcome(evaluate(sceneOf(*findConstruction("three-methods"), {triangle, ray})));
  const WorkingLine *line = outcome.explanation->find(id);
  return line ? *line : WorkingLine();
}

const Object triangle = TriangleObject{{2, 2, 1}, {8, 2, 3}, {2, 8, 5}};
const Object parallel = RayObject{{3, 6, 9}, {1, 1, 1}};

TEST(ThreeMethods, QuotientsOfARayThatIsParallel_GoUpToTheDivision) {
  const WorkingLine line = lineOf(triangle, parallel, "cramer-s");
  EXPECT_EQ(plainText(line), "D₁ = −30, D = 0");
  EXPECT_EQ(line.sentence, "D₁/D, which would be s, is not defined: nothing can be divided by 0.");
  EXPECT_EQ(line.asked, Asked::Nothing);
  EXPECT_EQ(plainText(lineOf(triangle, parallel, "pluecker-t")), "p₂ = −30, S = 0");
}

TEST(ThreeMethods, LinesThatNeedThePoint_AreNotThereWithoutIt) {
  for (const char *id : {"hit", "w", "perp-s", "mix", "pluecker-lambda", "agree-s"})
    EXPECT_TRUE(lineOf(triangle, parallel, id).chains.empty()) << id;
}

TEST(ThreeMethods, OfCornersOnOneLine_AreUndividedToo) {
  const Object degenerate = TriangleObject{{2, 2, 1}, {8, 2, 3}, {5, 2, 2}};
  EXPECT_TRUE(plainText(lineOf(degenerate, parallel, "cramer-t")).ends_with(", D = 0"));
  EXPECT_EQ(plainText(lineOf(degenerate, parallel, "perp-lambda")), "c·n = 0, r·n = 0");
}

} // namespace
} // namespace halfspace
