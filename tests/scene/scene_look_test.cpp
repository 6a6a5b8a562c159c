// What is seen of a scene: its tools, its ground, what stands out, and that nothing is cut off.
#include "tests/picture/marks.h"
#include "tests/scene/pictures.h"
#include "widgets/picture/composer.h"
#include "widgets/scene/shape_scene.h"

#include <gtest/gtest.h>

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <glm/geometric.hpp>

#include <functional>

namespace halfspace {
namespace {

Figure pointQ() { return {{withId(pointAt({11, 15, 8}), "Q", Subject::Point)}}; }

RgbaImage pictureOf(const PictureRequest &request) {
  auto picture = drawOffscreen(request, noLabels);
  EXPECT_TRUE(picture);
  return picture ? std::move(*picture) : RgbaImage();
}

/// How many pixels of two pictures of a size differ by more than a trace.
int differences(const RgbaImage &a, const RgbaImage &b) {
  int count = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const Rgba p = pixelAt(a, x, y);
      const Rgba q = pixelAt(b, x, y);
      count += std::abs(p.red - q.red) + std::abs(p.green - q.green) + std::abs(p.blue - q.blue) > 12;
    }
  return count;
}

/// The picture of a content and how it differs from that of the same content after a change.
int changedBy(const std::function<void(PictureRequest &)> &change) {
  PictureRequest request = requestFor(pointQ());
  const RgbaImage before = pictureOf(request);
  change(request);
  return differences(before, pictureOf(request));
}

TEST(Look, OfWhatTheHandHolds_IsDrawn) {
  EXPECT_EQ(changedBy([](PictureRequest &) {}), 0);
  EXPECT_GT(changedBy([](PictureRequest &request) {
              request.content.gizmo.emplace();
              request.content.gizmo->at = {11, 15, 8};
            }),
            100);
  EXPECT_GT(changedBy([](PictureRequest &request) {
              request.content.knobs.push_back({"k", {2, 2, 2}, {}, Subject::Plane, false});
            }),
            50);
  EXPECT_GT(changedBy([](PictureRequest &request) { request.content.dropLine = DropLine{{11, 15, 8}}; }), 50);
}

TEST(Look, OfAMarkThatStandsOut_IsAnother) {
  EXPECT_GT(changedBy([](PictureRequest &request) { request.content.highlighted = {"Q"}; }), 20);
  EXPECT_EQ(changedBy([](PictureRequest &request) { request.content.highlighted = {"other"}; }), 0);
}

TEST(Look, OfAMarkThatIsNotThereYet_IsThatOfNone) {
  PictureRequest request = requestFor(pointQ());
  request.content.arrival = {{"Q"}, 0};
  const RgbaImage arriving = pictureOf(request);
  // The axes reach as far as the figure, so that the place of a mark is known before it is there.
  PictureRequest other = requestFor({{withId(pointAt({11, 15, 8}), "R", Subject::Point)}});
  other.content.arrival = {{"R"}, 0};
  EXPECT_EQ(differences(arriving, pictureOf(other)), 0);
  EXPECT_GT(differences(arriving, pictureOf(requestFor(pointQ()))), 20);
}

TEST(Look, OnAStageFarFromTheGround_HasNeitherGridNorAxes) {
  PictureRequest request = requestFor({});
  const RgbaImage usual = pictureOf(request);
  request.content.stage.middle = {1000, 1000, 1000};
  const RgbaImage bare = pictureOf(request);
  EXPECT_GT(differences(usual, bare), 500);
  // The background alone: each row has one colour, which newer versions of VTK dither by one step.
  constexpr int ditherStep = 1;
  for (int y = 0; y < bare.height; y += 20)
    for (int x = 0; x < bare.width; x += 20) {
      const Rgba pixel = pixelAt(bare, x, y);
      const Rgba first = pixelAt(bare, 0, y);
      EXPECT_NEAR(pixel.red, first.red, ditherStep);
      EXPECT_NEAR(pixel.green, first.green, ditherStep);
      EXPECT_NEAR(pixel.blue, first.blue, ditherStep);
    }
}

TEST(Look, OfEachTheme_HasItsBackgroundFromTopToBottom) {
  for (const Theme &theme : themes()) {
    PictureRequest request = requestFor({});
    request.theme = theme;
    request.content.stage.middle = {1000, 1000, 1000};
    const RgbaImage picture = pictureOf(request);
    const auto isNear = [](Rgba pixel, Color color) {
      return std::abs(pixel.red - color.red) + std::abs(pixel.green - color.green) +
                 std::abs(pixel.blue - color.blue) <
             8;
    };
    EXPECT_TRUE(isNear(pixelAt(picture, 5, 1), theme.backgroundTop)) << theme.name;
    EXPECT_TRUE(isNear(pixelAt(picture, 5, picture.height - 2), theme.backgroundBottom)) << theme.name;
  }
}

TEST(Look, AtTwiceThePixelRatio_HasThickerLinesInTheSamePlaces) {
  const auto orangePixels = [](double pixelRatio) {
    PictureRequest request = requestFor(pointQ());
    request.pixelRatio = pixelRatio;
    const RgbaImage picture = pictureOf(request);
    int count = 0;
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x)
        count += pixelAt(picture, x, y).red - pixelAt(picture, x, y).blue > 60;
    return count;
  };
  EXPECT_NEAR(double(orangePixels(2)) / orangePixels(1), 4, 0.6) << "the ball's area";
}

void show(const PictureRequest &request, ShapeScene &scene) {
  Composer composer(noLabels.set);
  composer.setContent(request.content);
  composer.setView({request.camera, request.size, 1});
  scene.show(composer.compose());
}

struct Views : testing::TestWithParam<double> {};

TEST_P(Views, FromAnyHeight_CutOffNothingOfTheFigure) {
  const std::vector<Place> places{{0, 0, 0}, {11, 15, 8}, {-40, 3, 2}, {5, 90, -7}};
  Figure figure;
  for (const Place &place : places)
    figure.add(withId(pointAt(place), "p" + std::to_string(figure.marks.size())));
  for (const bool orthographic : {false, true}) {
    PictureRequest request = requestFor(figure);
    request.camera.height = GetParam();
    request.camera.orthographic = orthographic;
    ShapeScene scene(noLabels.paint);
    show(request, scene);
    double range[2] = {0, 0};
    scene.renderer()->GetActiveCamera()->GetClippingRange(range);
    EXPECT_GT(range[0], 0);
    for (const Place &place : places) {
      const double depth = glm::dot(place - request.camera.eye(), request.camera.viewDirection());
      EXPECT_LT(depth, range[1]);
      if (depth > 1e-3 * range[1]) {
        EXPECT_GT(depth, range[0]);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Heights, Views, testing::Values(1.0, 21.0, 400.0));

TEST(HighPlaces, FromTheSide_CutOffNothingThatStandsHigh) {
  const Place high(6, 8, 600);
  PictureRequest request = requestFor({{withId(pointAt(high), "Q")}});
  request.content.stage.middle = {1000, 1000, 0}; // without axes, which would reach as far
  request.camera.elevation = 1.2;
  request.camera.height = 400;
  ShapeScene scene(noLabels.paint);
  show(request, scene);
  double range[2] = {0, 0};
  scene.renderer()->GetActiveCamera()->GetClippingRange(range);
  EXPECT_GT(glm::dot(high - request.camera.eye(), request.camera.viewDirection()), range[0]);
}

TEST(Strips, OfAView_LookWhereTheirPartOfItIs) {
  const PictureRequest request = requestFor(pointQ());
  ShapeScene scene(noLabels.paint);
  show(request, scene);
  vtkCamera *camera = scene.renderer()->GetActiveCamera();
  const double whole = camera->GetParallelScale();
  scene.showStrip(0, 100);
  EXPECT_NEAR(camera->GetParallelScale(), whole / 4, 1e-9);
  EXPECT_GT(camera->GetWindowCenter()[1], 0) << "the upper strip";
  scene.showStrip(300, 100);
  EXPECT_LT(camera->GetWindowCenter()[1], 0);
  show(request, scene);
  EXPECT_NEAR(camera->GetParallelScale(), whole, 1e-9) << "all of it again";
  EXPECT_EQ(camera->GetWindowCenter()[1], 0);
}

} // namespace
} // namespace halfspace
