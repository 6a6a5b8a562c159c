// The labels of every step of every lesson in a figure 8 cm wide, in type of 9 pt.
#include "tests/exports/lesson_drawings.h"
#include "widgets/picture/screen_shapes.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

constexpr double smallWidth = 8 * pointsPerCentimetre;
constexpr double smallType = 9;

template <class Visit> void forEachSmallFigure(Visit visit) {
  const Theme &theme = *findTheme("print");
  for (const Lesson &lesson : library().lessons)
    for (const LessonStep &step : lesson.steps) {
      SCOPED_TRACE(lesson.id + ", " + step.title);
      visit(*shapesOfStep(lesson, &step, viewOnPaper({1600, 1000}, smallWidth, smallType, theme), theme)
                 .layer(Layer::Labels));
    }
}

TEST(SmallFigures, HaveNoLabelOverAnother) {
  std::size_t labels = 0;
  forEachSmallFigure([&](const std::vector<Shape> &shapes) {
    forEach<LabelShape>(shapes, [&](const Shape &, const LabelShape &label) {
      ++labels;
      forEach<LabelShape>(shapes, [&](const Shape &, const LabelShape &other) {
        EXPECT_TRUE(&label == &other || overlapArea(label.box, other.box) == 0)
            << label.latex << " and " << other.latex;
      });
    });
  });
  EXPECT_GT(labels, 1000U);
}

TEST(SmallFigures, HaveNoLeaderThroughALabel) {
  std::size_t leaders = 0;
  forEachSmallFigure([&](const std::vector<Shape> &shapes) {
    forEach<LeaderShape>(shapes, [&](const Shape &, const LeaderShape &leader) {
      ++leaders;
      forEach<LabelShape>(shapes, [&](const Shape &, const LabelShape &label) {
        EXPECT_EQ(lengthInside(label.box, leader.from, leader.to), 0) << label.latex;
      });
    });
  });
  EXPECT_GT(leaders, 50U);
}

} // namespace
} // namespace halfspace
