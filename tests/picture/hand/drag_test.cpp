#include "widgets/picture/hand/drag.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace halfspace {
namespace {

constexpr PixelSize size{1280, 800};
const Place start(11, 15, 8);
const DragConstraint horizontally = inPlane({0, 0, 1});
const DragConstraint upAndDown = alongLine({0, 0, 1});

/// Looks along −x, this many radians downward, at the place that is dragged.
Camera lookingDown(double elevation) {
  Camera camera;
  camera.target = start;
  camera.elevation = elevation;
  return camera;
}

glm::dvec2 pixelOf(const Camera &camera, Place place) { return glm::dvec2(*camera.project(place, size)); }

/// Where the pointer must drag `start` to when it goes to the pixel of `end`, grabbed a little off its
/// middle.
std::optional<Place> dragTo(const DragConstraint &constraint, const Camera &camera, Place end) {
  return dragged(constraint, camera, size, start, pixelOf(camera, start), pixelOf(camera, end));
}

TEST(Drag, InAPlaneReachesThePlaceOfThePlaneUnderThePointer) {
  const Place end(7, 13, 8);
  const auto place = dragTo(horizontally, lookingDown(0.6), end);
  ASSERT_TRUE(place);
  EXPECT_NEAR(glm::distance(*place, end), 0, 1e-9);
}

TEST(Drag, AlongALineStaysOnItWhereverThePointerGoes) {
  const Camera camera = lookingDown(0.6);
  const auto place = dragged(upAndDown, camera, size, start, pixelOf(camera, start), {900, 120});
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->x, start.x, 1e-9);
  EXPECT_NEAR(place->y, start.y, 1e-9);
  EXPECT_GT(place->z, start.z + 1);
}

TEST(Drag, AlongALineReachesThePlaceOfTheLineUnderThePointer) {
  const Place end = start + Place(1, 2, 2) * 1.5;
  const auto place = dragTo(alongLine({1, 2, 2}), lookingDown(0.6), end);
  ASSERT_TRUE(place);
  EXPECT_NEAR(glm::distance(*place, end), 0, 1e-9);
}

TEST(Drag, GrabbedOffItsMiddleDoesNotJump) {
  const Camera camera = lookingDown(0.6);
  const glm::dvec2 grabbed = pixelOf(camera, start) + glm::dvec2(6, -5);
  const auto place = dragged(horizontally, camera, size, start, grabbed, grabbed);
  ASSERT_TRUE(place);
  EXPECT_NEAR(glm::distance(*place, start), 0, 1e-12);
}

TEST(Drag, InAPlaneSeenEdgeOnIsRefused) {
  EXPECT_FALSE(isGrabbable(horizontally, lookingDown(leastPlaneGrabAngle - 0.01), start));
  EXPECT_FALSE(dragTo(horizontally, lookingDown(0.1), start + Place(0, 1, 0)));
  EXPECT_TRUE(isGrabbable(horizontally, lookingDown(leastPlaneGrabAngle + 0.01), start));
}

TEST(Drag, AlongALineThatPointsAtTheEyeIsRefused) {
  const double straightDown = std::acos(-1.0) / 2;
  EXPECT_FALSE(isGrabbable(upAndDown, lookingDown(straightDown - leastGrabAngle + 0.01), start));
  EXPECT_TRUE(isGrabbable(upAndDown, lookingDown(straightDown - leastGrabAngle - 0.01), start));
}

TEST(Drag, BeyondTheHorizonGivesNoPlace) {
  const Camera camera = lookingDown(0.3);
  const glm::dvec2 sky(640, -900);
  EXPECT_FALSE(dragged(horizontally, camera, size, start, pixelOf(camera, start), sky));
}

TEST(Drag, WithoutADirectionIsRefused) {
  EXPECT_FALSE(isGrabbable(alongLine({0, 0, 0}), lookingDown(0.6), start));
  EXPECT_FALSE(isGrabbable(inPlane({0, 0, 0}), lookingDown(0.6), start));
}

TEST(Drag, OnASphere_FollowsThePointerOverTheSideWhereItWasGrabbed) {
  const Camera camera = lookingDown(0.6);
  const Place center = start - Place(4, 0, 0); // the camera looks along −x: the front is where x is larger
  const Place front = center + 4.0 * glm::normalize(Place(1, 0.4, 0.3));
  const auto there = dragTo(onSphere(center), camera, front);
  ASSERT_TRUE(there);
  EXPECT_NEAR(glm::distance(*there, front), 0, 1e-9);
  const Place far = start - Place(8, 0, 0);
  const auto behind =
      dragged(onSphere(center), camera, size, far, pixelOf(camera, far), pixelOf(camera, front));
  ASSERT_TRUE(behind);
  EXPECT_NEAR(glm::distance(*behind, center), 4, 1e-9);
  EXPECT_LT(behind->x, center.x) << "on the far side, under the same pixel";
}

TEST(Drag, OnTheFarSideOfASphereAcrossItsMiddle_StaysThere) {
  Camera camera = lookingDown(0);
  const Place center = camera.eye() - Place(8, 0, 0);
  const Place left = center + Place(0, -4, 0); // seen from so near it belongs to the far side
  for (const double aside : {-3.0, -1.0, 0.0, 1.0, 3.0}) {
    const auto place = dragged(onSphere(center), camera, size, left, pixelOf(camera, left),
                               pixelOf(camera, center + Place(0, aside, 0)));
    ASSERT_TRUE(place);
    EXPECT_GT(glm::dot(*place - center, *place - camera.eye()), 0) << aside;
  }
}

TEST(Drag, BesideASphere_StaysOnItsOutline) {
  const Camera camera = lookingDown(0.6);
  const Place center = start - Place(4, 0, 0);
  const auto place = dragged(onSphere(center), camera, size, start, pixelOf(camera, start), {5, 300});
  ASSERT_TRUE(place);
  EXPECT_NEAR(glm::distance(*place, center), 4, 1e-9);
  const SightLine sight = camera.sightThrough(pixelOf(camera, *place), size);
  EXPECT_NEAR(glm::dot(*place - center, sight.direction), 0, 1e-6) << "where sights touch it";
}

} // namespace
} // namespace halfspace
