#include "tests/picture/marks.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace halfspace {
namespace {

const Place center(5, 4, 7);
const Place normal(1, 2, 2);

TEST(PlanePatch, WithoutCoveredPointsIsASquareInThePlaneAroundItsCentre) {
  const std::vector<Place> corners = cornersOf(patchAt(center, normal));
  ASSERT_EQ(corners.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(glm::dot(corners[i] - center, normal), 0, 1e-9);
    EXPECT_NEAR(glm::distance(corners[i], corners[(i + 1) % 4]), minimumPatchSide, 1e-9);
  }
  EXPECT_NEAR(glm::distance((corners[0] + corners[2]) / 2.0, center), 0, 1e-9);
}

TEST(PlanePatch, HasOnePairOfHorizontalSides) {
  const std::vector<Place> corners = cornersOf(patchAt(center, normal));
  EXPECT_NEAR(corners[0].z, corners[1].z, 1e-9);
  EXPECT_NEAR(corners[2].z, corners[3].z, 1e-9);
}

TEST(PlanePatch, GoesOnBehindACoveredPoint) {
  const Place level = glm::normalize(Place(-2, 1, 0));
  const std::vector<Place> corners = cornersOf(patchAt(center, normal, {center + level * 12.0}));
  double reach = 0;
  for (const Place &corner : corners)
    reach = std::max(reach, glm::dot(corner - center, level));
  EXPECT_NEAR(reach, 12 + patchMargin, 1e-9);
}

TEST(PlanePatch, IsNotStretchedByFarOrEndlessPoints) {
  const double endless = std::numeric_limits<double>::infinity();
  for (const Place &corner : cornersOf(patchAt(center, normal, {{1e7, 0, 0}, {endless, 0, 0}})))
    EXPECT_LE(glm::distance(corner, center), 2 * maximumPatchReach);
}

TEST(PlanePatch, OfAHorizontalPlaneIsLevel) {
  const std::vector<Place> corners = cornersOf(patchAt(center, {0, 0, -3}));
  ASSERT_EQ(corners.size(), 4U);
  for (const Place &corner : corners)
    EXPECT_NEAR(corner.z, center.z, 1e-9);
}

TEST(PlanePatch, WithAZeroNormalIsEmpty) { EXPECT_TRUE(cornersOf(patchAt(center, {0, 0, 0})).empty()); }

} // namespace
} // namespace halfspace
