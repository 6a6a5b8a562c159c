#include "widgets/picture/drawn_box.h"

#include "tests/picture/labels/vectors_only.h"
#include "tests/picture/marks.h"
#include "widgets/picture/composer.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

constexpr PixelSize size{1200, 800};

/// A figure without axes, ground and tools, seen from the front.
std::optional<PixelBox> boxOf(const Figure &figure) {
  SceneContent content;
  content.stage.middle = {1000, 1000, 1000};
  content.figure = figure;
  View view{{}, size, 1};
  view.camera.elevation = 0;
  view.camera.height = 8; // a unit has 100 pixels
  view.camera.orthographic = true;
  Composer composer(vectorsOnly());
  composer.setContent(std::move(content));
  composer.setView(std::move(view));
  return drawnBox(composer.compose());
}

TEST(DrawnBox, OfNothing_IsNone) { EXPECT_FALSE(boxOf({})); }

TEST(DrawnBox, OfALine_IsAroundIt_WithItsThickness) {
  Figure figure;
  figure.add(withId(segmentBetween({0, -2, -1}, {0, 3, 2}), "line"));
  const auto box = boxOf(figure);
  ASSERT_TRUE(box);
  constexpr double mostThickness = 10;
  EXPECT_LT(box->low.x, 400);
  EXPECT_GT(box->low.x, 400 - mostThickness);
  EXPECT_GT(box->high.x, 900);
  EXPECT_LT(box->high.x, 900 + mostThickness);
  EXPECT_LT(box->low.y, 200);
  EXPECT_GT(box->high.y, 500);
}

TEST(DrawnBox, OfWhatReachesBeyondTheView_EndsThere) {
  Figure figure;
  figure.add(withId(segmentBetween({0, -50, 0}, {0, 50, 0}), "line"));
  const auto box = boxOf(figure);
  ASSERT_TRUE(box);
  EXPECT_EQ(box->low.x, 0);
  EXPECT_EQ(box->high.x, size.width);
}

TEST(DrawnBox, HasLabelsInIt) {
  Figure figure;
  figure.add(withId(pointAt({0, 0, 0}), "point"));
  const auto bare = boxOf(figure);
  PointMark named = withId(pointAt({0, 0, 0}), "point");
  named.label = "P";
  figure.marks = {named};
  const auto labelled = boxOf(figure);
  ASSERT_TRUE(bare && labelled);
  EXPECT_GT(labelled->extent().x + labelled->extent().y, bare->extent().x + bare->extent().y);
}

} // namespace
} // namespace halfspace
