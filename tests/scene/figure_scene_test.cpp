#include "widgets/scene/figure_scene.h"

#include "tests/scene/marks.h"
#include "tests/scene/pictures.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

constexpr Rgba magenta{255, 0, 255, 255};
constexpr int labelWidth = 31;
constexpr int labelHeight = 13;

/// Only the mark's label has a picture: a plain rectangle.
std::shared_ptr<const LabelPicture> magentaForQ(const std::string &latex, const LabelStyle &) {
  if (latex != "Q")
    return noLabels({}, {});
  auto picture = std::make_shared<LabelPicture>();
  picture->width = labelWidth;
  picture->height = labelHeight;
  for (int i = 0; i < labelWidth * labelHeight; ++i)
    picture->rgba.insert(picture->rgba.end(), {255, 0, 255, 255});
  return picture;
}

Figure labelledPoint() {
  PointMark point = named(pointAt({11, 15, 8}), "point.Q", Subject::Point);
  point.label = "Q";
  return {{point}};
}

TEST(FigureScene, DrawsALabelTexelForPixel) {
  const auto picture = drawOffscreen(requestFor(labelledPoint()), magentaForQ);
  ASSERT_TRUE(picture);
  int count = 0;
  for (int y = 0; y < picture->height; ++y)
    for (int x = 0; x < picture->width; ++x)
      count += pixelAt(*picture, x, y) == magenta;
  EXPECT_EQ(count, labelWidth * labelHeight);
}

TEST(FigureScene, ALabelIsPartOfItsMark) {
  const PictureRequest request = requestFor(labelledPoint());
  FigureScene scene(magentaForQ);
  scene.setContent(request.content);
  scene.setView(request.camera, request.size, 1);
  scene.prepare();
  const auto point = request.camera.project({11, 15, 8}, request.size);
  ASSERT_TRUE(point);
  EXPECT_EQ(scene.markAt(glm::dvec2(*point)), "point.Q");
  EXPECT_EQ(scene.markAt(glm::dvec2(*point) + glm::dvec2(30, -14)), "point.Q");
  EXPECT_EQ(scene.markAt(glm::dvec2(*point) + glm::dvec2(-60, 40)), "");
}

TEST(FigureScene, SaysThatLabelsArePendingUntilTheirPicturesCome) {
  const PictureRequest request = requestFor(labelledPoint());
  bool ready = false;
  FigureScene scene([&](const std::string &latex, const LabelStyle &style) {
    return ready ? magentaForQ(latex, style) : nullptr;
  });
  scene.setContent(request.content);
  scene.setView(request.camera, request.size, 1);
  scene.prepare();
  EXPECT_TRUE(scene.labelsPending());
  ready = true;
  scene.prepare();
  EXPECT_FALSE(scene.labelsPending());
}

TEST(FigureScene, AsksForTypeInProportionToPixelRatioAndTheme) {
  const PictureRequest request = requestFor(labelledPoint());
  double asked = 0;
  FigureScene scene([&](const std::string &latex, const LabelStyle &style) {
    if (latex == "Q")
      asked = style.pixelSize;
    return noLabels({}, {});
  });
  Theme theme = *findTheme("light");
  theme.textScale = 1.5;
  scene.setTheme(theme);
  scene.setContent(request.content);
  scene.setView(request.camera, request.size, 2);
  scene.prepare();
  EXPECT_DOUBLE_EQ(asked, 22 * 2 * 1.5);
}

} // namespace
} // namespace halfspace
