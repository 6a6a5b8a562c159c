#include "widgets/picture/labels/label_requests.h"

#include "tests/picture/marks.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halfspace {
namespace {

View viewAtHeight(double height) {
  CameraView from;
  from.height = height;
  return {Camera(from), {900, 440}, 1};
}

std::vector<WrittenLabel> axisTexts(const View &view) {
  return writtenLabels({}, axisLabels({}, view.camera, 0, 1), themes().front(), view);
}

TEST(LabelRequests, NumbersAtTheAxes_ArePinnedBesideTheirTicks) {
  const auto texts = axisTexts(viewAtHeight(21));
  const auto numbers = std::count_if(texts.begin(), texts.end(), [](const WrittenLabel &text) {
    return text.stand == LabelStand::Pinned && text.anchors.size() == 1;
  });
  EXPECT_EQ(numbers, 7); // 5 and 10 on x and z, 5, 10 and 15 on y
}

TEST(LabelRequests, OfVeryManyMarks_AreBounded_AndThoseThatStandOutAreAmongThem) {
  SceneContent content;
  for (int i = 0; i < 1000; ++i) {
    PointMark point = withId(pointAt({i % 30 - 15.0, i / 30 - 15.0, 0}), "P" + std::to_string(i));
    point.label = "P";
    content.figure.marks.push_back(point);
  }
  content.highlighted = {"P999"};
  const auto texts = writtenLabels(content, {}, themes().front(), viewAtHeight(60));
  EXPECT_EQ(texts.size(), mostMarkLabels);
  EXPECT_TRUE(
      std::any_of(texts.begin(), texts.end(), [](const WrittenLabel &text) { return text.id == "P999"; }));
}

TEST(LabelRequests, NumbersOfAMarkWithoutALetter_StandBesideItAlone) {
  PointMark point = withId(pointAt({1, 2, 3}), "Q");
  SceneContent content;
  content.figure.marks.push_back(point);
  EXPECT_TRUE(writtenLabels(content, {}, themes().front(), viewAtHeight(21)).empty());
  content.figure.marks.change(0, [](Mark &mark) { baseOf(mark).numbers = "+"; });
  EXPECT_EQ(writtenLabels(content, {}, themes().front(), viewAtHeight(21)).front().latex, "+");
}

TEST(LabelRequests, LabelOfAGivenPoint_KeepsOffItsThickerBall) {
  const auto clearanceOf = [](Subject subject) {
    PointMark point = withId(pointAt({1, 2, 3}), "Q", subject);
    point.label = "Q";
    SceneContent content;
    content.figure.marks.push_back(point);
    return writtenLabels(content, {}, themes().front(), viewAtHeight(21)).front().anchors.front().clearance;
  };
  EXPECT_GT(clearanceOf(Subject::Point), clearanceOf(Subject::Plane));
}

TEST(LabelRequests, LabelWhereLinesAreThick_KeepsOffAsMuchFarther) {
  PointMark point = withId(pointAt({1, 2, 3}), "Q", Subject::Point);
  point.label = "Q";
  SceneContent content;
  content.figure.marks.push_back(point);
  const auto clearanceIn = [&](const Theme &theme) {
    return writtenLabels(content, {}, theme, viewAtHeight(21)).front().anchors.front().clearance;
  };
  Theme thick = themes().front();
  thick.lineScale = 1.5;
  EXPECT_DOUBLE_EQ(clearanceIn(thick), 1.5 * clearanceIn(themes().front()));
}

TEST(LabelRequests, NamesOfTheAxes_GiveWay) {
  const auto texts = axisTexts(viewAtHeight(21));
  for (const char *name : {"x", "y", "z"}) {
    const auto found = std::find_if(texts.begin(), texts.end(),
                                    [&](const WrittenLabel &text) { return text.latex == name; });
    ASSERT_NE(found, texts.end());
    EXPECT_EQ(found->stand, LabelStand::Beside);
    EXPECT_FALSE(found->anchors.empty());
  }
}

TEST(LabelRequests, LabelOfAnArc_StandsBesideTheArc) {
  ArcMark arc;
  arc.id = "theta";
  arc.label = "\\theta";
  arc.center = {6, 8, 4};
  arc.from = {1, 0, 0};
  arc.to = {0, 1, 1};
  SceneContent content;
  content.figure.marks.push_back(arc);
  const View view = viewAtHeight(21);
  const auto texts = writtenLabels(content, {}, themes().front(), view);
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_EQ(texts.front().anchors.size(), 3U);
}

} // namespace
} // namespace halfspace
