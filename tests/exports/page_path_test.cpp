#include "widgets/exports/page_path.h"

#include "widgets/exports/page_number.h"
#include "widgets/exports/page_polygon.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace halfspace {
namespace {

std::vector<glm::dvec2> circleSpots(int count, double radius) {
  std::vector<glm::dvec2> spots;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    spots.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return spots;
}

/// By how much a path around the origin leaves a circle, at most.
double farthestFrom(double radius, const PagePath &path) {
  double farthest = 0;
  for (std::size_t i = 1; i < path.steps.size(); ++i) {
    const PageStep &step = path.steps[i];
    if (step.kind != PageStep::Kind::Curve)
      continue;
    for (const double t : {0.25, 0.5, 0.75}) {
      const double u = 1 - t;
      const glm::dvec2 spot = path.steps[i - 1].to * (u * u * u) + step.first * (3 * u * u * t) +
                              step.second * (3 * u * t * t) + step.to * (t * t * t);
      farthest = std::max(farthest, std::abs(glm::length(spot) - radius));
    }
  }
  return farthest;
}

TEST(PageNumber, HasTwoDecimals_WithoutZerosAtItsEnd) {
  EXPECT_EQ(pageNumber(12.5), "12.5");
  EXPECT_EQ(pageNumber(3), "3");
  EXPECT_EQ(pageNumber(0.125), "0.13");
  EXPECT_EQ(pageNumber(-0.034), "-0.03");
  EXPECT_EQ(pageNumber(-0.001), "0");
  EXPECT_EQ(pageNumber(10.05), "10.05");
  EXPECT_EQ(pageNumber(1e300), "1000000");
}

TEST(SmoothPath, ThroughManySpotsOfACircle_IsThatCircleInFewCurves) {
  const PagePath path = smoothPath(circleSpots(96, 100), true);
  EXPECT_LT(path.steps.size(), 26U);
  EXPECT_LT(farthestFrom(100, path), 0.01);
  EXPECT_EQ(path.steps.back().kind, PageStep::Kind::Close);
}

TEST(SmoothPath, KeepsCorners_AndDropsWhatLiesOnAStraightLine) {
  const PagePath path = smoothPath({{0, 0}, {1, 0}, {2, 0}, {2, 5}}, false);
  ASSERT_EQ(path.steps.size(), 3U);
  EXPECT_EQ(path.steps[1].kind, PageStep::Kind::Line);
  EXPECT_EQ(path.steps[1].to, glm::dvec2(2, 0));
}

TEST(CirclePath, IsACircle) { EXPECT_LT(farthestFrom(10, circlePath({0, 0}, 10)), 0.003); }

TEST(HullOf, GoesAroundAllSpots_OneWay) {
  const auto hull = hullOf({{0, 0}, {4, 0}, {2, 1}, {4, 4}, {0, 4}, {2, 3}});
  EXPECT_EQ(hull.size(), 4U);
  EXPECT_GT(turningArea(hull), 0);
}

} // namespace
} // namespace halfspace
