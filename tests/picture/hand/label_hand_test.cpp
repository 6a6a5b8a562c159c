// Labels that a hand moves: they go with it, stay there in pictures of every size, and others make room.
#include "widgets/picture/hand/label_hand.h"

#include "lessons/scene/evaluation.h"
#include "tests/lessons/scenes.h"
#include "tests/picture/labels/vectors_only.h"
#include "widgets/picture/composer.h"
#include "widgets/picture/design_scale.h"
#include "widgets/picture/lesson_picture.h"
#include "widgets/picture/screen_shapes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace halfspace {
namespace {

/// Boxes of labels lie on whole pixels, and the halo around them is so, too.
constexpr double rounding = 2.5;

struct LabelsInTheHand : testing::Test {
  Scene scene = test::distanceScene();
  PixelSize size{1200, 800};
  Camera camera{CameraView()};

  [[nodiscard]] ShapeList picture() const {
    const Evaluation evaluation = evaluate(scene);
    Composer composer(vectorsOnly());
    composer.setContent(contentOf(nullptr, nullptr, evaluation, Stage()));
    composer.setView({camera, size, ownPixelRatio(size)});
    return composer.compose();
  }
  void doWith(const ChangeLabel &change) { scene = test::edited(scene, {change}); }
  /// Takes the label of a mark at its middle, and moves it by so many pixels.
  void drag(const std::string &mark, glm::dvec2 way) {
    const PixelBox box = boxOf(picture(), mark);
    const glm::dvec2 grip = (box.low + box.high) / 2.0;
    const auto held = takeLabel(picture(), grip);
    ASSERT_TRUE(held);
    ASSERT_EQ(held->mark, mark);
    doWith(moveLabel(*held, grip + way));
  }
  static const LabelShape *labelOf(const ShapeList &list, const std::string &mark) {
    for (const Shape &shape : *list.layer(Layer::Labels))
      if (const auto *label = std::get_if<LabelShape>(&shape.form); label && shape.mark == mark)
        return label;
    return nullptr;
  }
  static PixelBox boxOf(const ShapeList &list, const std::string &mark) {
    const LabelShape *label = labelOf(list, mark);
    EXPECT_TRUE(label) << mark;
    return label ? label->box : PixelBox();
  }
  static std::size_t leadersOf(const ShapeList &list, const std::string &mark) {
    std::size_t count = 0;
    forEach<LeaderShape>(*list.layer(Layer::Labels), [&](const Shape &shape, const LeaderShape &) {
      count += shape.mark == mark ? 1U : 0U;
    });
    return count;
  }
  static void expectNear(const PixelBox &box, const PixelBox &wanted) {
    EXPECT_LT(glm::distance(box.low, wanted.low), rounding);
    EXPECT_LT(glm::distance(box.high, wanted.high), rounding);
  }
};

TEST_F(LabelsInTheHand, GoWithThePointer) {
  for (const glm::dvec2 way : {glm::dvec2(0, 0), {40, -30}, {-90, 10}, {-30, 70}}) {
    const PixelBox before = boxOf(picture(), "Q");
    drag("Q", way);
    expectNear(boxOf(picture(), "Q"), {before.low + way, before.high + way});
  }
}

TEST_F(LabelsInTheHand, StandAtTheSamePlaceBesideTheirMarks_InPicturesOfEverySize) {
  drag("Q", {70, -50});
  const auto spotIn = [&](PixelSize other) {
    size = other;
    const ShapeList list = picture();
    const LabelShape *label = labelOf(list, "Q");
    return ((label->box.low + label->box.high) / 2.0 - *label->anchor) / label->style.pixelSize;
  };
  const glm::dvec2 here = spotIn({1200, 800});
  EXPECT_GT(here.x, 2);
  EXPECT_LT(here.y, -2);
  const auto roundingIn = [](PixelSize picture) {
    return rounding / (markTextSize * ownPixelRatio(picture));
  };
  for (const PixelSize other : {PixelSize{600, 400}, {2400, 1600}, {3000, 800}})
    EXPECT_LT(glm::distance(spotIn(other), here), roundingIn(other) + roundingIn({1200, 800}));
}

TEST_F(LabelsInTheHand, MoveAlongWithTheirMarks) {
  drag("Q", {70, -50});
  const ShapeList before = picture();
  test::setCoordinate(scene, {"Q", 0}, {9, 12, 8});
  const ShapeList after = picture();
  const glm::dvec2 way = *labelOf(after, "Q")->anchor - *labelOf(before, "Q")->anchor;
  ASSERT_GT(glm::length(way), 20);
  const PixelBox box = boxOf(before, "Q");
  expectNear(boxOf(after, "Q"), {box.low + way, box.high + way});
}

TEST_F(LabelsInTheHand, FarFromTheirMarks_HaveALeader_AndNoneNearby) {
  drag("Q", {0, 0});
  EXPECT_EQ(leadersOf(picture(), "Q"), 0U);
  drag("Q", {150, -100});
  EXPECT_EQ(leadersOf(picture(), "Q"), 1U);
}

TEST_F(LabelsInTheHand, OnTheirFace_HaveNoLeader) {
  const ShapeList before = picture();
  const PixelBox box = boxOf(before, "E");
  drag("E", *labelOf(before, "E")->anchor - (box.low + box.high) / 2.0 + glm::dvec2(30, 20));
  EXPECT_EQ(leadersOf(picture(), "E"), 0U) << "the plane is there";
}

TEST_F(LabelsInTheHand, AreMadeRoomForByOthers) {
  const ShapeList before = picture();
  const PixelBox there = boxOf(before, "distance.F");
  const PixelBox own = boxOf(before, "Q");
  drag("Q", (there.low + there.high - own.low - own.high) / 2.0);
  const ShapeList after = picture();
  EXPECT_GT(overlapArea(boxOf(after, "Q"), there), 0);
  forEach<LabelShape>(*after.layer(Layer::Labels), [&](const Shape &shape, const LabelShape &label) {
    if (shape.mark != "Q") {
      EXPECT_EQ(overlapArea(label.box, boxOf(after, "Q")), 0) << shape.mark << label.latex;
    }
  });
}

TEST_F(LabelsInTheHand, ThatGrow_GrowAwayFromTheirMarks) {
  drag("Q", {60, 0});
  const PixelBox right = boxOf(picture(), "Q");
  EXPECT_EQ(scene.labels.at("Q").spot->side, LabelSpot::Side::Left);
  SceneContent content = contentOf(nullptr, nullptr, evaluate(scene), Stage());
  content.shown.coordinates = true;
  Composer composer(vectorsOnly());
  composer.setView({camera, size, ownPixelRatio(size)});
  composer.setContent(content);
  const PixelBox longer = boxOf(composer.compose(), "Q");
  EXPECT_NEAR(longer.low.x, right.low.x, 1);
  EXPECT_GT(longer.high.x, right.high.x + 50);
  drag("Q", {-200, 0});
  EXPECT_EQ(scene.labels.at("Q").spot->side, LabelSpot::Side::Right);
}

TEST_F(LabelsInTheHand, BeyondTheEdge_AreMovedInside_AndFarBeyondAreLeftOut) {
  const double toTheRight = size.width - boxOf(picture(), "Q").high.x;
  drag("Q", {toTheRight + 5, 0});
  EXPECT_EQ(boxOf(picture(), "Q").high.x, size.width);
  drag("Q", {300, 0});
  EXPECT_FALSE(labelOf(picture(), "Q"));
}

TEST_F(LabelsInTheHand, AreHidden_ShownAgainWhereTheyStood_AndPutBack) {
  const ShapeList before = picture();
  drag("Q", {70, -50});
  const PixelBox there = boxOf(picture(), "Q");
  doWith(hideLabel(scene, "Q", true));
  EXPECT_FALSE(labelOf(picture(), "Q"));
  EXPECT_TRUE(labelOf(picture(), "E"));
  doWith(hideLabel(scene, "Q", false));
  EXPECT_EQ(boxOf(picture(), "Q"), there);
  doWith(putLabelBack("Q"));
  EXPECT_EQ(boxOf(picture(), "Q"), boxOf(before, "Q"));
  EXPECT_EQ(scene, test::distanceScene());
}

TEST_F(LabelsInTheHand, AreThoseOfMarksAlone) {
  const ShapeList list = picture();
  std::size_t numbers = 0;
  forEach<LabelShape>(*list.layer(Layer::Labels), [&](const Shape &shape, const LabelShape &label) {
    const glm::dvec2 middle = (label.box.low + label.box.high) / 2.0;
    EXPECT_EQ(takeLabel(list, middle).has_value(), !shape.mark.empty()) << label.latex;
    numbers += shape.mark.empty() ? 1U : 0U;
  });
  EXPECT_GT(numbers, 3U);
  EXPECT_FALSE(takeLabel(list, {3, 3}));
}

} // namespace
} // namespace halfspace
