#include "widgets/picture/camera.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

constexpr PixelSize size{1280, 800};

Camera slanted(bool orthographic) {
  CameraView view;
  view.from = {1, 0.7, 0.5};
  view.at = {6, 8, 4};
  view.height = 21;
  Camera camera(view);
  camera.orthographic = orthographic;
  return camera;
}

class CameraOfEitherKind : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(PerspectiveAndOrthographic, CameraOfEitherKind, testing::Bool());

TEST_P(CameraOfEitherKind, ProjectsTheTargetToTheMiddle) {
  const Camera camera = slanted(GetParam());
  const auto pixel = camera.project(camera.target, size);
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->x, 640, 1e-9);
  EXPECT_NEAR(pixel->y, 400, 1e-9);
  EXPECT_NEAR(pixel->z, 0.5, 1e-9);
}

TEST_P(CameraOfEitherKind, ShowsItsHeightFromBottomToTop) {
  const Camera camera = slanted(GetParam());
  const auto top = camera.project(camera.target + camera.up() * 10.5, size);
  const auto right = camera.project(camera.target + camera.right() * 10.5, size);
  ASSERT_TRUE(top && right);
  EXPECT_NEAR(top->y, 0, 1e-9);
  EXPECT_NEAR(right->x, 640 + 400, 1e-9);
}

TEST_P(CameraOfEitherKind, SeesAPlaceThroughThePixelThatItProjectsTo) {
  const Camera camera = slanted(GetParam());
  const Place place(11, 15, 8);
  const auto pixel = camera.project(place, size);
  ASSERT_TRUE(pixel);
  const SightLine sight = camera.sightThrough(glm::dvec2(*pixel), size);
  EXPECT_NEAR(glm::length(sight.direction), 1, 1e-12);
  EXPECT_NEAR(glm::length(glm::cross(place - sight.origin, sight.direction)), 0, 1e-9);
}

TEST_P(CameraOfEitherKind, ZoomKeepsThePlaceUnderThePointer) {
  Camera camera = slanted(GetParam());
  const glm::dvec2 pointer(300, 650);
  const SightLine sight = camera.sightThrough(pointer, size);
  const double depth = glm::dot(camera.target - sight.origin, camera.viewDirection());
  const Place held =
      sight.origin + sight.direction * (depth / glm::dot(sight.direction, camera.viewDirection()));
  camera.zoom(0.4, pointer, size);
  const auto pixel = camera.project(held, size);
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(camera.height, 8.4, 1e-12);
  EXPECT_NEAR(pixel->x, pointer.x, 1e-6);
  EXPECT_NEAR(pixel->y, pointer.y, 1e-6);
}

TEST_P(CameraOfEitherKind, PanMovesThePictureWithThePointer) {
  Camera camera = slanted(GetParam());
  const Place before = camera.target;
  camera.pan({37, -21}, size);
  const auto pixel = camera.project(before, size);
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->x, 640 + 37, 1e-9);
  EXPECT_NEAR(pixel->y, 400 - 21, 1e-9);
}

TEST_P(CameraOfEitherKind, FittedShowsAllPlacesInTheRoomAndFillsIt) {
  const std::vector<Place> places{{0, 0, 0}, {11, 15, 8}, {5, -2, 9}, {30, 3, -4}};
  for (const PixelBox &room :
       {PixelBox{{0, 0}, {1280, 800}}, PixelBox{{700, 100}, {1200, 700}}, PixelBox{{20, 500}, {1260, 790}}}) {
    const Camera camera = fitted(slanted(GetParam()), places, size, room);
    glm::dvec2 low = room.high;
    glm::dvec2 high = room.low;
    for (const Place &place : places) {
      const auto pixel = camera.project(place, size);
      ASSERT_TRUE(pixel);
      low = glm::min(low, glm::dvec2(*pixel));
      high = glm::max(high, glm::dvec2(*pixel));
    }
    const glm::dvec2 before = low - room.low;
    const glm::dvec2 behind = room.high - high;
    EXPECT_GE(std::min({before.x, before.y, behind.x, behind.y}), -1e-6);
    EXPECT_NEAR(std::min(before.x, before.y), 0, 1e-6) << "as large as can be";
    EXPECT_NEAR(before.x, behind.x, 0.2 * room.extent().x) << "about in the middle";
    EXPECT_DOUBLE_EQ(camera.azimuth, slanted(false).azimuth);
  }
}

TEST_P(CameraOfEitherKind, ResizedKeepsWhatWasBetweenTheSides) {
  const Camera camera = slanted(GetParam());
  const Place left = camera.target - camera.right() * 14.0;
  for (const PixelSize now : {PixelSize{300, 700}, PixelSize{1280, 400}, PixelSize{2000, 800}}) {
    const auto pixel = keptBetweenSides(camera, size, now).project(left, now);
    ASSERT_TRUE(pixel);
    EXPECT_GE(pixel->x, 0) << now.width;
    EXPECT_LT(pixel->x, now.width / 2.0);
  }
  EXPECT_EQ(keptBetweenSides(camera, size, {1000, 400}), camera) << "there is more room";
}

TEST_P(CameraOfEitherKind, UnitsPerPixelMatchesTheProjection) {
  const Camera camera = slanted(GetParam());
  const Place at(11, 15, 8);
  const double unit = camera.unitsPerPixel(at, size);
  const auto a = camera.project(at, size);
  const auto b = camera.project(at + camera.right() * unit * 5.0, size);
  ASSERT_TRUE(a && b);
  EXPECT_NEAR(b->x - a->x, 5, 1e-9);
}

TEST(Camera, WhenTurnedFarUpNeverEndsUpsideDown) {
  Camera camera = slanted(false);
  camera.turn(1, 100);
  EXPECT_LE(camera.elevation, Camera::maxElevation);
  EXPECT_GT(camera.up().z, 0);
  camera.turn(1, -100);
  EXPECT_GT(camera.up().z, 0);
}

TEST(Camera, MadeFromAViewLooksFromThere) {
  const Camera camera = slanted(false);
  const Place from = glm::normalize(Place(1, 0.7, 0.5));
  EXPECT_NEAR(glm::distance(glm::normalize(camera.eye() - camera.target), from), 0, 1e-12);
}

TEST(Camera, MadeFromAViewWithoutDirectionStillLooks) {
  CameraView view;
  view.from = {0, 0, 0};
  EXPECT_TRUE(Camera(view).project(view.at, size));
}

TEST(Camera, BehindTheEyeProjectsNothing) {
  const Camera camera = slanted(false);
  const Place behind = camera.eye() - camera.viewDirection();
  EXPECT_FALSE(camera.project(behind, size));
  EXPECT_EQ(camera.unitsPerPixel(behind, size), 0);
}

TEST(Camera, NotFinitePlacesProjectNothing) { EXPECT_FALSE(Camera().project({std::nan(""), 0, 0}, size)); }

TEST(Camera, FittedToNothingStaysAsItIs) {
  const Camera camera = slanted(false);
  EXPECT_EQ(fitted(camera, {}, size, {{0, 0}, {1280, 800}}), camera);
}

} // namespace
} // namespace halfspace
