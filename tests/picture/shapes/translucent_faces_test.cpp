#include "widgets/picture/shapes/translucent_faces.h"

#include "tests/picture/marks.h"
#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace halfspace {
namespace {

const Color red{255, 0, 0};
const Color blue{0, 0, 255};

Face squareAcross(double x, Color color) {
  return {{{x, -2, -2}, {x, 2, -2}, {x, 2, 2}, {x, -2, 2}}, color, 0.3};
}
Face floorAt(double z, Color color) { return {{{-2, -2, z}, {2, -2, z}, {2, 2, z}, {-2, 2, z}}, color, 0.3}; }

double areaOf(const Face &face) {
  Place area(0);
  for (std::size_t i = 1; i + 1 < face.corners.size(); ++i)
    area += glm::cross(face.corners[i] - face.corners[0], face.corners[i + 1] - face.corners[0]) / 2.0;
  return glm::length(area);
}

Place middleOf(const Face &face) {
  Place sum(0);
  for (const Place &corner : face.corners)
    sum += corner / static_cast<double>(face.corners.size());
  return sum;
}

TEST(TranslucentFaces, ParallelFacesComeBackToFrontFromBothSides) {
  const FaceOrder order({squareAcross(1, red), squareAcross(-1, blue)});
  const auto fromFront = order.backToFront({10, 0, 0, 1});
  ASSERT_EQ(fromFront.size(), 2U);
  EXPECT_EQ(fromFront[0]->color, blue);
  EXPECT_EQ(fromFront[1]->color, red);
  EXPECT_EQ(order.backToFront({-10, 0, 0, 1})[0]->color, red);
}

TEST(TranslucentFaces, CrossingFacesAreSplitAndInterleaved) {
  const FaceOrder order({squareAcross(0, red), floorAt(0, blue)});
  const auto faces = order.backToFront({10, 0, 3, 1});
  ASSERT_EQ(faces.size(), 3U);
  EXPECT_LT(middleOf(*faces[0]).x, -0.5);
  EXPECT_EQ(faces[1]->color, red);
  EXPECT_GT(middleOf(*faces[2]).x, 0.5);
  EXPECT_NEAR(areaOf(*faces[0]) + areaOf(*faces[2]), 16, 1e-9);
}

TEST(TranslucentFaces, SeenOrthographicallyTheDirectionDecides) {
  const FaceOrder order({squareAcross(1, red), squareAcross(-1, blue)});
  EXPECT_EQ(order.backToFront({1, 0, 0, 0})[1]->color, red);
  EXPECT_EQ(order.backToFront({-1, 0, 0, 0})[1]->color, blue);
}

TEST(TranslucentFaces, InOnePlaneKeepTheirOrderFromBothSides) {
  const FaceOrder order({floorAt(0, red), floorAt(0, blue)});
  for (const double z : {5.0, -5.0}) {
    const auto faces = order.backToFront({0, 0, z, 1});
    ASSERT_EQ(faces.size(), 2U);
    EXPECT_EQ(faces[1]->color, blue);
  }
}

TEST(TranslucentFaces, ThatAllPassThroughOneAnother_AreCutSoManyTimesAndNoMore) {
  constexpr int count = 300;
  std::vector<Face> faces;
  for (int i = 0; i < count; ++i) {
    const Place normal(std::cos(i * 0.7), std::sin(i * 1.3), std::cos(i * 2.1) + 0.01);
    faces.push_back({cornersOf(patchAt(normal * 0.1, normal)), red, 0.3});
  }
  const std::size_t pieces = FaceOrder(faces).backToFront({30, 20, 10, 1}).size();
  EXPECT_GT(pieces, 2000U); // they are cut …
  EXPECT_LE(pieces, 4096U + count);
}

TEST(TranslucentFaces, FacesWithoutAreaAreLeftOut) {
  const FaceOrder order({{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, red, 0.3}, {{}, red, 0.3}});
  EXPECT_TRUE(order.backToFront({1, 0, 0, 1}).empty());
}

} // namespace
} // namespace halfspace
