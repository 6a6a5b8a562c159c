#include "lessons/scene/object_of_mark.h"

#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

TEST(ObjectOfMark, OfObjectsWhatIsMadeAndConstructions_IsTheirId) {
  const Evaluation evaluation = evaluate(test::distanceScene());
  EXPECT_EQ(objectOfMark(evaluation, "Q"), "Q");
  EXPECT_EQ(objectOfMark(evaluation, "E.n"), "E");
  EXPECT_EQ(objectOfMark(evaluation, "E/side"), "E");
  EXPECT_EQ(objectOfMark(evaluation, "distance.F"), "distance.F");
  EXPECT_EQ(objectOfMark(evaluation, "distance.F/angle"), "distance.F");
  EXPECT_EQ(objectOfMark(evaluation, "distance.w"), "distance");
  EXPECT_EQ(objectOfMark(evaluation, "X.n"), "");
  EXPECT_EQ(objectOfMark(evaluation, ""), "");
}

TEST(ObjectOfMark, OfEachMarkOfAFigure_IsAnObjectOrAConstructionOfIt) {
  const Evaluation evaluation = evaluate(test::distanceScene());
  for (const Mark &mark : figureOf(evaluation).marks)
    EXPECT_NE(objectOfMark(evaluation, baseOf(mark).id), "") << baseOf(mark).id;
}

} // namespace
} // namespace halfspace
