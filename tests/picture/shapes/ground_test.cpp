#include "tests/picture/shapes/mesh_of.h"
#include "widgets/picture/shapes/ground.h"

#include "tests/picture/marks.h"
#include "widgets/picture/labels/number_text.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

TEST(Ground, GridLinesStandAtWholeStepsWithTheMajorOnesOnTop) {
  Camera camera;
  camera.target = {103.4, -17.2, 5};
  camera.height = 105;
  const double step = gridStep(camera.height);
  bool sawMajor = false;
  for (const Grid::Line &line : gridAround(camera).lines) {
    const bool alongX = line.points.front().y == line.points.back().y;
    const double number = (alongX ? line.points.front().y : line.points.front().x) / step;
    EXPECT_NEAR(number, std::round(number), 1e-9);
    EXPECT_EQ(line.isMajor, std::fmod(std::abs(std::round(number)), 5) == 0) << number;
    EXPECT_TRUE(line.isMajor || !sawMajor);
    sawMajor = sawMajor || line.isMajor;
    for (const Place &point : line.points) {
      EXPECT_EQ(point.z, 0);
      EXPECT_LT(glm::distance(point, Place(103.4, -17.2, 0)), 0.63 * camera.height);
    }
  }
  EXPECT_TRUE(sawMajor);
}

TEST(Ground, AxesGoFromTheirLowEndsToTheirHighOnesWithATickForEachNumber) {
  const AxesReach reach{{-3.2, 0, 0}, {12.2, 16.2, 11.2}};
  const Mesh mesh = meshOf(axesOf(reach, Camera(), themes().front(), 1));
  glm::vec3 low(0);
  glm::vec3 high(0);
  for (const glm::vec3 &position : mesh.positions) {
    low = glm::min(low, position);
    high = glm::max(high, position);
  }
  EXPECT_NEAR(low.x, -3.2, 1e-5);
  EXPECT_NEAR(high.x, 12.2, 1e-5);
  EXPECT_NEAR(high.y, 16.2, 1e-5);
  EXPECT_NEAR(high.z, 11.2, 1e-5);
  const auto standsAt = [&](const Place &tip) {
    return std::any_of(mesh.positions.begin(), mesh.positions.end(),
                       [&](const glm::vec3 &p) { return glm::distance(Place(p), tip) < 0.06; });
  };
  EXPECT_TRUE(standsAt({5, -0.35, 0}) && standsAt({10, -0.35, 0})) << "beside x";
  const double elevation = Camera().elevation;
  const Place besideY = Place(0, 15, 0) + 0.35 * Place(-std::sin(elevation), 0, std::cos(elevation));
  EXPECT_TRUE(standsAt(besideY)) << "beside y, square to the sight";
  EXPECT_FALSE(standsAt({0, -0.35, 0})) << "the origin has none";
}

TEST(Ground, NegativePartsOfAnAxisAreNumberedToo) {
  std::vector<std::string> ofX;
  for (const AxisLabel &label : axisLabels({{-11.2, 0, 0}, {12.2, 16.2, 11.2}}, Camera(), 0, 1))
    if (label.at.y < 0 && label.at.z == 0)
      ofX.push_back(label.latex);
  EXPECT_EQ(ofX, (std::vector<std::string>{"-10", "-5", "5", "10"}));
}

TEST(Ground, FromVeryNearOnlyTheTicksInSightAreNumbered) {
  Camera near;
  near.target = {30, 0, 0};
  near.height = 0.1;
  const auto labels = axisLabels({{-60, 0, 0}, {60, 60, 60}}, near, 0, 0.01);
  EXPECT_GT(labels.size(), 6U);
  EXPECT_LT(labels.size(), 400U);
  for (const AxisLabel &label : labels)
    if (!label.isName && label.at.x > 1) {
      EXPECT_NEAR(label.at.x, 30, 1);
    }
}

TEST(Ground, NumbersAreSeenBesideTheirAxesFromEverySide) {
  constexpr PixelSize size{900, 600};
  for (int axis = 0; axis < 3; ++axis)
    for (const double azimuth : {-2.5, -1.0, 0.1, 0.8, 2.0})
      for (const double elevation : {-0.5, 0.2, 0.6, 1.2}) {
        Camera camera;
        camera.azimuth = azimuth;
        camera.elevation = elevation;
        Place place(0);
        place[axis] = 7;
        const auto seen = [&](const Place &at) { return glm::dvec2(camera.project(at, size).value()); };
        const glm::dvec2 along = glm::normalize(seen(place) - seen(Place(0)));
        const glm::dvec2 beside = seen(axisNumber(axis, 7, camera, 0, 1).at) - seen(place);
        EXPECT_GT(std::abs(along.x * beside.y - along.y * beside.x), 15) << axis << " " << azimuth;
      }
}

TEST(Ground, NumbersAreWrittenInUnitsOfTheScene) {
  const Camera camera;
  const AxisLabel ofX = axisNumber(0, 7, camera, 0, 1);
  EXPECT_EQ(ofX.latex, "7");
  EXPECT_LT(ofX.at.y, 0);
  EXPECT_EQ(axisNumber(2, 7, camera, 3, 1).latex, "7000");
  EXPECT_DOUBLE_EQ(axisNumber(0, 7, camera, 0, 2).at.y, 2 * ofX.at.y);
}

TEST(Ground, AxesOfAFigureReachBeyondItsPointsAndNotBeyondWhatRunsOn) {
  LineMark line;
  line.direction = {-1, -1, 0};
  EXPECT_EQ(axesAround({{line}}), AxesReach());
  EXPECT_GT(axesAround({{pointAt({20, 0, 0})}}).high.x, 20);
  EXPECT_LT(axesAround({{pointAt({0, -4.5, 0})}}).low.y, -4.5);
  EXPECT_EQ(axesAround({{patchAt({20, 30, 40}, {0, 0, 1})}}), AxesReach());
}

TEST(NumberText, LeavesOutDigitsThatSayNothing) {
  EXPECT_EQ(numberText(8), "8");
  EXPECT_EQ(numberText(-2.50), "-2.5");
  EXPECT_EQ(numberText(1.0 / 3), "\\approx 0.333");
  EXPECT_EQ(numberText(-0.0001), "\\approx 0");
  EXPECT_EQ(numberText(100), "100");
}

} // namespace
} // namespace halfspace
