#include "geometry/triangle_mesh.h"
#include "tests/picture/marks.h"
#include "tests/scene/pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <thread>

namespace halfspace {
namespace {

/// The middle of all pixels that are more orange than anything else in the picture is.
glm::dvec2 middleOfOrange(const RgbaImage &picture) {
  glm::dvec2 sum(0);
  double count = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const Rgba pixel = pixelAt(picture, x, y);
      if (pixel.red - pixel.blue > 60) {
        sum += glm::dvec2(x + 0.5, y + 0.5);
        ++count;
      }
    }
  return sum / count;
}

class Offscreen : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(PerspectiveAndOrthographic, Offscreen, testing::Bool());

TEST_P(Offscreen, DrawsAPointWhereTheCameraProjectsIt) {
  for (const Place at : {Place(11, 15, 8), Place(2, 1, 3), Place(9, 6, 9)}) {
    PictureRequest request = requestFor({{withId(pointAt(at), "Q", Subject::Point)}});
    request.camera.orthographic = GetParam();
    const auto picture = drawOffscreen(request, noLabels);
    ASSERT_TRUE(picture) << picture.problem().text();
    const auto expected = request.camera.project(at, request.size);
    ASSERT_TRUE(expected);
    const glm::dvec2 found = middleOfOrange(*picture);
    EXPECT_NEAR(found.x, expected->x, 0.5);
    EXPECT_NEAR(found.y, expected->y, 0.5);
  }
}

TEST(OffscreenPicture, IsTheSameWhenDrawnAgain) {
  const PictureRequest request = requestFor({{withId(patchAt({6, 8, 4}, {1, 2, 2}), "E", Subject::Plane)}});
  const auto first = drawOffscreen(request, noLabels);
  const auto second = drawOffscreen(request, noLabels);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->rgba, second->rgba);
}

TEST(OffscreenPainter, DrawsEachPictureAsIfItWereItsFirst) {
  PictureRequest point = requestFor({{withId(pointAt({11, 15, 8}), "Q", Subject::Point)}});
  PictureRequest clear = requestFor({{withId(patchAt({6, 8, 4}, {1, 2, 2}), "E", Subject::Plane)}});
  clear.transparent = true;
  clear.size = {300, 500};
  clear.theme = *findTheme("dark");
  PictureRequest large = requestFor({{withId(pointAt({2, 3, 4}), "R")}});
  large.size = {6000, 3000};
  OffscreenPainter painter(noLabels.set, noLabels.paint);
  for (const PictureRequest &request : {point, clear, point, large, clear, point}) {
    const auto picture = painter.draw(request);
    const auto alone = drawOffscreen(request, noLabels);
    ASSERT_TRUE(picture && alone);
    EXPECT_EQ(picture->rgba, alone->rgba) << request.size.width;
  }
}

TEST(OffscreenPainter, AfterAPictureThatIsRefused_DrawsTheNext) {
  OffscreenPainter painter(noLabels.set, noLabels.paint);
  PictureRequest request = requestFor({});
  request.size = {0, 0};
  EXPECT_FALSE(painter.draw(request));
  EXPECT_TRUE(painter.draw(requestFor({})));
}

TEST(OffscreenPainter, ThatRanOutOfMemory_BeginsAnew) {
  bool isFull = true;
  const LabelSetter set = [&](const std::string &) -> LabelFormula {
    if (isFull)
      throw std::bad_alloc();
    return std::make_shared<const math::Layout>();
  };
  OffscreenPainter painter(set, {});
  const PictureRequest request = requestFor({});
  const auto refused = painter.draw(request);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.problem().sentence.find("not enough memory"), std::string::npos);
  isFull = false;
  const auto picture = painter.draw(request);
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->rgba, drawOffscreen(request, noLabels)->rgba);
}

TEST(JobThread, DoesAllJobsInOneThreadThatIsNotTheCallers) {
  JobThread thread;
  std::thread::id first;
  thread.run([&] { first = std::this_thread::get_id(); });
  EXPECT_NE(first, std::this_thread::get_id());
  for (int i = 0; i < 1000; ++i) {
    std::thread::id later;
    thread.run([&] { later = std::this_thread::get_id(); });
    ASSERT_EQ(later, first);
  }
}

TEST(JobThread, WhatAJobThrows_IsThrownAtTheCaller_AndTheNextIsDone) {
  JobThread thread;
  EXPECT_THROW(thread.run([] { throw std::bad_alloc(); }), std::bad_alloc);
  bool isDone = false;
  thread.run([&] { isDone = true; });
  EXPECT_TRUE(isDone);
}

/// A rectangle, 4 long and 1 wide, in the plane z = 0 of its own space.
MeshMark rectangleAt(const Place &place, const glm::dmat3 &axes) {
  auto mesh = std::make_shared<TriangleMesh>();
  mesh->corners = {{0, -0.5, 0}, {4, -0.5, 0}, {4, 0.5, 0}, {0, 0.5, 0}};
  mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
  MeshMark mark;
  mark.id = "target";
  mark.box = {{0, -0.5, 0}, {4, 0.5, 0}};
  mark.mesh = std::move(mesh);
  mark.place = place;
  mark.axes = axes;
  return mark;
}

TEST(OffscreenPicture, AMeshIsDrawnWhereItIsPlaced_AndTurned) {
  const PictureRequest empty = requestFor({});
  const auto background = drawOffscreen(empty, noLabels);
  ASSERT_TRUE(background);
  const glm::dmat3 quarterTurn{Place(0, 1, 0), Place(-1, 0, 0), Place(0, 0, 1)};
  const auto covers = [&](const MeshMark &mesh, const Place &place) {
    const auto picture = drawOffscreen(requestFor({{mesh}}), noLabels);
    EXPECT_TRUE(picture);
    const glm::dvec3 pixel = *empty.camera.project(place, empty.size);
    return pixelAt(*picture, pixel).red < pixelAt(*background, pixel).red - 8;
  };
  const MeshMark along = rectangleAt({6, 8, 4}, glm::dmat3(1));
  EXPECT_TRUE(covers(along, {9, 8, 4}));
  EXPECT_FALSE(covers(along, {6, 11, 4}));
  const MeshMark turned = rectangleAt({6, 8, 4}, quarterTurn);
  EXPECT_FALSE(covers(turned, {9, 8, 4}));
  EXPECT_TRUE(covers(turned, {6, 11, 4}));
}

TEST(OffscreenPicture, TheGridIsSeenOnTheShadowOfAMesh) {
  const PictureRequest request = requestFor({{rectangleAt({4, 8.6, 4}, glm::dmat3(1))}});
  const auto picture = drawOffscreen(request, noLabels);
  const auto unshaded = drawOffscreen(requestFor({}), noLabels);
  ASSERT_TRUE(picture && unshaded);
  // In the middle of a field, and on the line y = 10, which is one of the darker ones.
  const glm::dvec3 inField = *request.camera.project({4.5, 9.75, 0}, request.size);
  const glm::dvec3 onLine = *request.camera.project({4.5, 10, 0}, request.size);
  EXPECT_LT(pixelAt(*picture, inField).red, pixelAt(*unshaded, inField).red - 8) << "in the shadow";
  int darkest = 255;
  for (const double right : {-1, 0, 1})
    for (const double down : {-1, 0, 1})
      darkest = std::min(darkest, pixelAt(*picture, onLine + glm::dvec3(right, down, 0)).red);
  EXPECT_LT(darkest, pixelAt(*picture, inField).red - 8);
}

TEST(OffscreenPicture, TwiceAsLargeShowsEverythingTwiceAsLarge) {
  PictureRequest request = requestFor({{withId(pointAt({11, 15, 8}), "Q", Subject::Point)}});
  const auto small = drawOffscreen(request, noLabels);
  request.size = {1280, 800};
  const auto large = drawOffscreen(request, noLabels);
  ASSERT_TRUE(small && large);
  const auto orangePixels = [](const RgbaImage &picture) {
    double count = 0;
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x)
        count += pixelAt(picture, x, y).red - pixelAt(picture, x, y).blue > 60;
    return count;
  };
  EXPECT_NEAR(orangePixels(*large) / orangePixels(*small), 4, 0.4);
}

TEST_P(Offscreen, TooLargeToBeDrawnAtOnceHasNoSeams) {
  PictureRequest request = requestFor({{withId(pointAt({11, 15, 8}), "Q", Subject::Point)}});
  request.camera.orthographic = GetParam();
  request.size = {6000, 3000};
  const auto picture = drawOffscreen(request, noLabels);
  ASSERT_TRUE(picture);
  const auto expected = request.camera.project({11, 15, 8}, request.size);
  const glm::dvec2 found = middleOfOrange(*picture);
  EXPECT_NEAR(found.x, expected->x, 1);
  EXPECT_NEAR(found.y, expected->y, 1);
  // The background's 17 shades run once over the whole height, at the left where no grid is: a strip with a
  // gradient of its own would jump back.
  for (int y = 1; y < picture->height; ++y)
    ASSERT_LE(std::abs(pixelAt(*picture, 1, y).red - pixelAt(*picture, 1, y - 1).red), 2) << "row " << y;
}

TEST(OffscreenPicture, TransparentHasStraightAlpha) {
  PictureRequest request = requestFor({{withId(patchAt({6, 8, 12}, {1, 0.6, 0.5}), "E", Subject::Plane)}});
  request.transparent = true;
  const auto picture = drawOffscreen(request, noLabels);
  ASSERT_TRUE(picture);
  EXPECT_EQ(pixelAt(*picture, 2, 2), (Rgba{0, 0, 0, 0}));
  const Rgba face = pixelAt(*picture, *request.camera.project({6, 8, 12}, request.size));
  EXPECT_NEAR(face.alpha, 255 * request.theme.planeOpacity, 2);
  EXPECT_NEAR(face.red, request.theme.planeFace.red, 5);
  EXPECT_NEAR(face.green, request.theme.planeFace.green, 5);
  EXPECT_NEAR(face.blue, request.theme.planeFace.blue, 5);
}

/// A point whose shadow lies in the middle of a field of the grid.
struct ShadowOnTheGround : testing::Test {
  PictureRequest request = requestFor({{withId(pointAt({6.5, 7.7, 8}), "Q", Subject::Point)}});
  glm::dvec3 shadow = request.camera.project({4.5, 10.5, 0}, request.size).value();
  glm::dvec3 beside = request.camera.project({4.5, 12.5, 0}, request.size).value();
};

TEST_F(ShadowOnTheGround, OfATransparentPictureIsLeftOut) {
  const auto opaque = drawOffscreen(request, noLabels);
  request.transparent = true;
  const auto clear = drawOffscreen(request, noLabels);
  ASSERT_TRUE(opaque && clear);
  EXPECT_LT(pixelAt(*opaque, shadow).red, pixelAt(*opaque, beside).red - 4);
  EXPECT_LT(pixelAt(*clear, shadow).alpha, 20);
}

TEST_F(ShadowOnTheGround, OfAContentWithoutShadowsIsLeftOut_AndTheGridStays) {
  PictureRequest empty = request;
  empty.content.figure = {};
  request.content.hasShadows = false;
  const auto unshaded = drawOffscreen(request, noLabels);
  const auto ground = drawOffscreen(empty, noLabels);
  ASSERT_TRUE(unshaded && ground);
  EXPECT_EQ(pixelAt(*unshaded, shadow), pixelAt(*ground, shadow));
  const glm::dvec3 onLine = *request.camera.project({4.5, 10, 0}, request.size);
  EXPECT_EQ(pixelAt(*unshaded, onLine), pixelAt(*ground, onLine));
}

TEST(OffscreenPicture, OpaqueIsOpaqueEverywhere) {
  const auto picture = drawOffscreen(requestFor({{withId(patchAt({6, 8, 4}, {1, 2, 2}), "E")}}), noLabels);
  ASSERT_TRUE(picture);
  for (std::size_t i = 3; i < picture->rgba.size(); i += 4)
    ASSERT_EQ(picture->rgba[i], 255);
}

TEST(OffscreenPicture, WhatLiesBehindAFaceIsPalerThanBeforeIt) {
  const Place toEye = Place(1, 0.6, 0.5) * 3.0;
  const Place target(6, 8, 9);
  const auto orangeOf = [&](Place at) {
    PictureRequest request = requestFor(
        {{withId(patchAt(target, toEye), "E", Subject::Plane), withId(pointAt(at), "Q", Subject::Point)}});
    const auto picture = drawOffscreen(request, noLabels);
    const Rgba pixel = pixelAt(*picture, *request.camera.project(at, request.size));
    return pixel.red - pixel.blue;
  };
  EXPECT_GT(orangeOf(target + toEye), orangeOf(target - toEye) + 40);
}

TEST(OffscreenPicture, OfAnImpossibleSizeIsRefusedWithASentence) {
  for (const PixelSize size : {PixelSize{0, 400}, PixelSize{640, -1}, PixelSize{maxPictureSide + 1, 400}}) {
    PictureRequest request = requestFor({});
    request.size = size;
    const auto picture = drawOffscreen(request, noLabels);
    ASSERT_FALSE(picture);
    EXPECT_NE(picture.problem().sentence.find("16384"), std::string::npos);
  }
}

} // namespace
} // namespace halfspace
