// Labels that somebody has put somewhere stand there on paper, too.
#include "lessons/scene/edit.h"
#include "tests/exports/lesson_drawings.h"
#include "widgets/exports/page_polygon.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace halfspace {
namespace {

/// The lesson on signed distances with what is done to a label of its scene.
Lesson lessonWith(const ChangeLabel &change) {
  Lesson lesson = *library().find("signed-distance");
  auto scene = apply(lesson.scene, change);
  EXPECT_TRUE(scene);
  lesson.scene = std::move(*scene);
  return lesson;
}

const FormulaPart *labelOf(const Drawing &drawing, const std::string &mark) {
  for (const DrawingPart &part : drawing.parts)
    if (const auto *formula = std::get_if<FormulaPart>(&part); formula && formula->mark == mark)
      return formula;
  return nullptr;
}

/// Where the ball of a point is in the drawing.
glm::dvec2 ballOf(const Drawing &drawing, const std::string &mark) {
  for (const DrawingPart &part : drawing.parts)
    if (const auto *path = std::get_if<PathPart>(&part); path && path->mark == mark && path->fill) {
      std::vector<glm::dvec2> spots;
      for (const PageStep &step : path->path.steps)
        if (step.kind != PageStep::Kind::Close)
          spots.push_back(step.to);
      const PixelBox box = boxAround(spots);
      return (box.low + box.high) / 2.0;
    }
  ADD_FAILURE() << mark;
  return {};
}

TEST(LabelsByHand, OnPaper_StandAsManyEmFromTheirMark_InFiguresOfEverySize) {
  const LabelSpot spot{{2.5, -1.5}, LabelSpot::Side::Left};
  const Lesson lesson = lessonWith({"Q", LabelByHand{spot}});
  for (const auto &[width, typeSize] : {std::pair(226.0, 9.0), {340.0, 9.0}, {340.0, 12.0}}) {
    const Drawing drawing = drawingOfStep(lesson, lesson.steps.back(), {width}, typeSize);
    const FormulaPart *label = labelOf(drawing, "Q");
    ASSERT_TRUE(label);
    EXPECT_NEAR(label->size, typeSize, 1e-9);
    // The formula begins behind its halo; its baseline is below the middle of the letter.
    const glm::dvec2 way = (label->start - ballOf(drawing, "Q")) / typeSize;
    EXPECT_NEAR(way.x, spot.offset.x + haloWidth, 0.15);
    EXPECT_NEAR(way.y, spot.offset.y + 0.3, 0.25);
  }
}

TEST(LabelsByHand, ThatAreHidden_AreNotInTheDrawing_ButTheirMarksAre) {
  const Lesson lesson = lessonWith({"Q", LabelByHand{{}, true}});
  const Drawing drawing = drawingOfStep(lesson, lesson.steps.back());
  EXPECT_FALSE(labelOf(drawing, "Q"));
  ballOf(drawing, "Q");
}

} // namespace
} // namespace halfspace
