#include "widgets/picture/shapes/mesh.h"

#include "tests/picture/marks.h"
#include "tests/picture/shapes/solid_mesh.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halfspace {
namespace {

const Color red{255, 0, 0};

void expectSound(const Mesh &mesh) {
  EXPECT_EQ(mesh.positions.size(), mesh.normals.size());
  EXPECT_EQ(mesh.positions.size(), mesh.colors.size());
  for (const glm::ivec3 &triangle : mesh.triangles)
    for (int i = 0; i < 3; ++i)
      ASSERT_LT(static_cast<std::size_t>(triangle[i]), mesh.positions.size());
  for (const glm::vec3 &normal : mesh.normals)
    ASSERT_NEAR(glm::length(normal), 1, 1e-4);
}

/// The lowest and highest coordinate along an axis.
std::pair<double, double> spanOf(const Mesh &mesh, int axis) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const glm::vec3 &position : mesh.positions) {
    low = std::min<double>(low, position[axis]);
    high = std::max<double>(high, position[axis]);
  }
  return {low, high};
}

TEST(Mesh, TubeReachesFromEndToEndAndIsAsThickAsAsked) {
  Mesh mesh;
  addTube(mesh, {1, 2, 3}, {1, 2, 8}, 0.25, red);
  expectSound(mesh);
  EXPECT_NEAR(spanOf(mesh, 2).first, 3, 1e-6);
  EXPECT_NEAR(spanOf(mesh, 2).second, 8, 1e-6);
  for (const glm::vec3 &p : mesh.positions)
    EXPECT_LE(std::hypot(p.x - 1, p.y - 2), 0.25 + 1e-6);
}

TEST(Mesh, RingOfACornerIsMitredToItsOutside) {
  Mesh mesh;
  addRing(mesh, std::vector<Place>{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, 0.1, red);
  expectSound(mesh);
  for (const int axis : {0, 1}) {
    EXPECT_NEAR(spanOf(mesh, axis).first, -0.1, 1e-3);
    EXPECT_NEAR(spanOf(mesh, axis).second, 4.1, 1e-3);
  }
  EXPECT_NEAR(spanOf(mesh, 2).second, 0.1, 1e-3);
}

TEST(Mesh, DashesBeginAndEndWithTheSegmentAndLeaveGaps) {
  Mesh dashed;
  addDashes(dashed, {0, 0, 0}, {10, 0, 0}, 0.1, {0.5, 0.35}, red);
  expectSound(dashed);
  EXPECT_NEAR(spanOf(dashed, 0).first, 0, 1e-5);
  EXPECT_NEAR(spanOf(dashed, 0).second, 10, 1e-5);
  Mesh one;
  addTube(one, {0, 0, 0}, {10, 0, 0}, 0.1, red);
  EXPECT_GT(dashed.positions.size(), 8 * one.positions.size());
}

TEST(Mesh, ArrowEndsAtItsTip) {
  Mesh mesh;
  addArrow(mesh, {1, 1, 1}, {0, 0, 6}, 0.1, red);
  expectSound(mesh);
  EXPECT_NEAR(spanOf(mesh, 2).second, 7, 1e-6);
  EXPECT_NEAR(spanOf(mesh, 0).second, 1.3, 1e-3);
}

TEST(Mesh, WithoutLengthNothingIsAdded) {
  Mesh mesh;
  addTube(mesh, {1, 2, 3}, {1, 2, 3}, 0.1, red);
  addArrow(mesh, {1, 2, 3}, {0, 0, 0}, 0.1, red);
  addDashes(mesh, {1, 2, 3}, {1, 2, 3}, 0.1, {0.4, 0.3}, red);
  addCone(mesh, {1, 2, 3}, {1, 2, 3}, 0.1, red);
  EXPECT_TRUE(mesh.positions.empty());
}

TEST(Solids, OfEveryKindOfMarkAreSound) {
  Figure figure{{withId(pointAt({1, 1, 1}), "p"), withId(segmentBetween({0, 0, 0}, {3, 4, 5}), "s"),
                 withId(patchAt({1, 1, 1}, {1, 2, 2}), "E"),
                 withId(polygonOf({{0, 0, 0}, {3, 0, 0}, {0, 3, 1}}), "T")}};
  ArcMark arc;
  arc.from = {1, 0, 0};
  arc.to = {-1, 0, 0};
  RightAngleMark corner;
  corner.first = {0, 0, 2};
  corner.second = {3, 0, 0};
  figure.add(withId(arc, "arc"));
  figure.add(withId(corner, "corner"));
  for (const Mark &mark : figure.marks) {
    const Mesh mesh = solidMesh({{mark}}, {}, themes().front(), 1);
    EXPECT_FALSE(mesh.positions.empty()) << baseOf(mark).id;
    expectSound(mesh);
  }
}

TEST(Solids, NotFiniteMarksAreLeftOut) {
  const double endless = std::numeric_limits<double>::infinity();
  const Figure figure{
      {withId(pointAt({0, endless, 0}), "p"), withId(segmentBetween({0, 0, 0}, {std::nan(""), 0, 0}), "s")}};
  EXPECT_TRUE(solidMesh(figure, {}, themes().front(), 1).positions.empty());
}

TEST(Solids, HighlightedMarksAreThicker_ButBallsDoNotSwell) {
  const auto growth = [](const Figure &figure, int axis) {
    return spanOf(solidMesh(figure, {"p"}, themes().front(), 1), axis).second /
           spanOf(solidMesh(figure, {}, themes().front(), 1), axis).second;
  };
  EXPECT_GT(growth({{withId(segmentBetween({0, 0, 0}, {0, 0, 4}), "p")}}, 0), 1.3);
  const double ofBall = growth({{withId(pointAt({0, 0, 0}), "p")}}, 0);
  EXPECT_GT(ofBall, 1.1);
  EXPECT_LT(ofBall, 1.3);
}

TEST(Solids, WarningsHaveTheWarningColour) {
  PointMark point = withId(pointAt({0, 0, 0}), "p", Subject::Ray);
  point.role = Role::Warning;
  EXPECT_EQ(solidMesh({{point}}, {}, themes().front(), 1).colors.front(), themes().front().warning);
}

TEST(Solids, ArrivingGrowOutOfThinPaleLines) {
  const Figure figure{
      {withId(pointAt({1, 2, 3}), "p", Subject::Point), withId(pointAt({9, 9, 9}), "q", Subject::Point)}};
  const Theme &theme = themes().front();
  const auto at = [&](double presence) { return solidMesh(figure, {}, theme, 1, {{"p"}, presence}); };
  const Mesh all = solidMesh(figure, {}, theme, 1);
  EXPECT_EQ(at(0).positions.size(), all.positions.size() / 2);
  EXPECT_NE(at(0.5).colors.front(), all.colors.front());
  EXPECT_LT(at(0.5).positions.front().z, 3);
  EXPECT_GT(at(0.5).positions.front().z, all.positions.front().z);
  EXPECT_EQ(at(1).positions, all.positions);
  EXPECT_EQ(at(0.5).colors.back(), all.colors.back());
}

TEST(Solids, OfVeryManyPoints_AreCoarser) {
  const auto cornersOfPoints = [](int count) {
    Figure figure;
    for (int i = 0; i < count; ++i)
      figure.marks.push_back(pointAt({double(i), 0, 0}));
    return solidMesh(figure, {}, themes().front(), 1).positions.size();
  };
  EXPECT_EQ(cornersOfPoints(100), 100 * cornersOfPoints(1));
  EXPECT_LT(cornersOfPoints(1000), 300 * cornersOfPoints(1));
}

} // namespace
} // namespace halfspace
