#include "widgets/picture/shapes/ground.h"

#include "widgets/picture/labels/number_text.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halfspace {
namespace {

TEST(Ground, AtTheUsualHeightTheGridHasOneUnit) { EXPECT_DOUBLE_EQ(gridStep(21), 1); }

TEST(Ground, FarAwayTheGridIsCoarserAndNearItIsFiner) {
  EXPECT_DOUBLE_EQ(gridStep(105), 5);
  EXPECT_DOUBLE_EQ(gridStep(4.2), 0.2);
}

TEST(Ground, GridLinesFadeToNothingAtTheirEnds) {
  const Grid grid = gridAround(Camera());
  ASSERT_FALSE(grid.lines.empty());
  double strongest = 0;
  for (const Grid::Line &line : grid.lines) {
    EXPECT_NEAR(line.strengths.front(), 0, 1e-9);
    EXPECT_NEAR(line.strengths.back(), 0, 1e-9);
    EXPECT_EQ(line.points.size(), line.strengths.size());
    strongest = std::max(strongest, *std::max_element(line.strengths.begin(), line.strengths.end()));
  }
  EXPECT_DOUBLE_EQ(strongest, 1);
}

TEST(Ground, AxesReachBeyondEveryPlaceButNotWithoutBound) {
  const AxesReach reach = axesFor({{30, 2, -3}, {1e9, 0, 0}});
  EXPECT_GT(reach.high.x, 30);
  EXPECT_LT(reach.high.x, 100);
  EXPECT_LT(reach.low.z, -3);
  EXPECT_DOUBLE_EQ(reach.high.y, AxesReach().high.y);
  EXPECT_DOUBLE_EQ(reach.low.y, 0);
}

TEST(Ground, AxesAreNumberedAtEveryFifthStepAndNamed) {
  std::vector<std::string> texts;
  for (const AxisLabel &label : axisLabels({}, Camera(), 0, 1))
    texts.push_back(label.latex);
  EXPECT_EQ(texts, (std::vector<std::string>{"5", "10", "x", "5", "10", "15", "y", "5", "10", "z"}));
}

TEST(NumberText, LeavesOutDigitsThatSayNothing) {
  EXPECT_EQ(numberText(8), "8");
  EXPECT_EQ(numberText(-2.50), "-2.5");
  EXPECT_EQ(numberText(1.0 / 3), "0.333");
  EXPECT_EQ(numberText(-0.0001), "0");
  EXPECT_EQ(numberText(100), "100");
}

} // namespace
} // namespace halfspace
