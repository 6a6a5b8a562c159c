#include "tests/picture/shapes/mesh_of.h"
#include "widgets/picture/shapes/silhouette.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace halfspace {
namespace {

const SphereMark ball{{"S"}, {1, 2, 3}, 2};

Camera cameraFrom(Place from) { return Camera(CameraView{from, {0, 0, 0}, 20}); }

/// The distance of a point from the line through the eye and a place.
double distanceFromSight(Place point, Place eye, Place through) {
  const Place sight = glm::normalize(through - eye);
  return glm::length(glm::cross(point - eye, sight));
}

TEST(Silhouette, InPerspective_IsWhereSightsTouchTheBall) {
  for (const Place from : {Place(1, 0, 0), Place(1, -2, 0.5), Place(-3, 1, 2)}) {
    const Camera camera = cameraFrom(from);
    const auto circle = silhouetteOf(ball, camera);
    ASSERT_TRUE(circle);
    for (const Place &place : circleAround(circle->center, circle->axis, circle->radius, 24)) {
      EXPECT_NEAR(glm::distance(place, ball.center), ball.radius, 1e-9) << "it lies on the ball";
      EXPECT_NEAR(distanceFromSight(ball.center, camera.eye(), place), ball.radius, 1e-9)
          << "and is its edge";
    }
  }
}

TEST(Silhouette, WithoutPerspective_IsAGreatCircleAcrossTheSight) {
  Camera camera = cameraFrom({1, -2, 0.5});
  camera.orthographic = true;
  const auto circle = silhouetteOf(ball, camera);
  ASSERT_TRUE(circle);
  EXPECT_EQ(circle->center, ball.center);
  EXPECT_EQ(circle->radius, ball.radius);
  EXPECT_NEAR(std::abs(glm::dot(circle->axis, camera.viewDirection())), 1, 1e-12);
}

TEST(Silhouette, FromWithin_IsNone) {
  const Camera camera = cameraFrom({1, 0, 0});
  EXPECT_FALSE(silhouetteOf(SphereMark{{"S"}, camera.eye(), 1}, camera));
  EXPECT_FALSE(silhouetteOf(SphereMark{{"S"}, camera.eye() + Place(0.5, 0, 0), 1}, camera));
}

TEST(Silhouette, OfAFigure_IsDrawnForEachBallThatIsThere) {
  const View view{cameraFrom({1, -2, 0.5}), {800, 600}, 1};
  const auto corners = [&](const Figure &figure) {
    return meshOf(silhouettesOf(figure, {}, {}, themes().front(), view)).positions.size();
  };
  EXPECT_EQ(corners({{PointMark{{"Q"}, {0, 0, 0}}}}), 0U);
  const std::size_t one = corners({{ball}});
  EXPECT_GT(one, 0U);
  EXPECT_EQ(corners({{ball, PointMark{{"Q"}, {0, 0, 0}}, ball}}), 2 * one);
}

} // namespace
} // namespace halfspace
