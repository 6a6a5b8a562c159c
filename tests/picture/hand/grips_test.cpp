// Which handle a pixel grabs: the one that is seen there.
#include "widgets/picture/hand/grips.h"

#include "tests/lessons/scenes.h"
#include "widgets/picture/hand/handle_drag.h"
#include "widgets/picture/shapes/gizmo_shape.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

/// A scene seen level from +x: y runs to the right, z up.
struct Seen {
  Scene scene;
  std::string selected{};
  View view = fromTheFront();

  static View fromTheFront() {
    View view;
    view.camera.orthographic = true;
    view.camera.elevation = 0.3;
    view.size = {800, 800};
    return view;
  }
  glm::dvec2 pixelOf(const std::string &id) const {
    return glm::dvec2(view.camera.project(shownPlace(handle(scene, id)), view.size).value());
  }
  std::string grabbedAt(glm::dvec2 pixel) const {
    const Figure figure = figureOf(evaluate(scene));
    return handleGrabbedAt(pixel, gripsOf(handlesOf(scene), selected, figure, themes().front(), view),
                           grabMargin * view.pixelRatio);
  }
  std::string beside(const std::string &id, glm::dvec2 way) const { return grabbedAt(pixelOf(id) + way); }
};

Entry point(const std::string &name, const ExactVec3 &at) { return {name, PointObject{at}}; }

TEST(Grips, OfAPoint_AreItsBallAndALittleBeside) {
  const Seen seen{{{point("A", {0, 0, 0})}}};
  EXPECT_EQ(seen.beside("A", {0, 0}), "A");
  EXPECT_EQ(seen.beside("A", {11, 0}), "A") << "on the ball";
  EXPECT_EQ(seen.beside("A", {0, -12 - grabMargin + 1}), "A");
  EXPECT_EQ(seen.beside("A", {0, -13 - grabMargin}), "");
}

TEST(Grips, OfASelectedPoint_ReachAsFarAsTheRingAroundIt) {
  const glm::dvec2 inRing(0, -modeRingRadius + 1);
  EXPECT_EQ((Seen{{{point("A", {0, 0, 0})}}}.beside("A", inRing)), "");
  EXPECT_EQ((Seen{{{point("A", {0, 0, 0})}}, "A"}.beside("A", inRing)), "A");
}

TEST(Grips, OfTwoBallsAtAPixel_TheOneInFrontWins) {
  // x runs towards the eye.
  const Seen seen{{{point("front", {5, 0, 0}), point("back", {-5, 0, 0})}}};
  const glm::dvec2 between = (seen.pixelOf("front") + seen.pixelOf("back")) / 2.0;
  EXPECT_NE(seen.grabbedAt(between), "front") << "they lie apart";
  for (const double elevation : {0.0, 0.02}) {
    Seen level = seen;
    level.view.camera.elevation = elevation;
    EXPECT_EQ(level.beside("back", {0, 0}), "front");
  }
}

/// Seen from above, the cross, which is lifted over the corner in its middle, reaches over it.
TEST(Grips, OfACornerUnderTheCrossOfItsTriangle_TheCornerWins) {
  Seen seen{{{{"T", TriangleObject{{0, 0, 0}, {0, 4, 0}, {0, -4, 0}}}}}};
  seen.view.camera.elevation = 1.2;
  const glm::dvec2 away = seen.pixelOf("T.whole") - seen.pixelOf("T.P0");
  ASSERT_LT(glm::length(away), 20);
  EXPECT_EQ(seen.beside("T.P0", {0, 0}), "T.P0");
  EXPECT_EQ(seen.beside("T.P0", away / 2.0), "T.P0");
  EXPECT_EQ(seen.beside("T.whole", away / 2.0), "T.whole");
}

TEST(Grips, OfTwoBallsInOnePlace_TheSelectedOneWins) {
  for (const std::string selected : {"first", "second"})
    EXPECT_EQ(
        (Seen{{{point("first", {1, 2, 3}), point("second", {1, 2, 3})}}, selected}.beside(selected, {0, 0})),
        selected);
}

TEST(Grips, BesideTwoBalls_TheNearerOnTheScreenWins) {
  const Seen seen{{{point("left", {0, 0, 0}), point("right", {0, q(3, 4), 0})}}};
  EXPECT_EQ(seen.beside("left", {-14, 0}), "left");
  EXPECT_EQ(seen.beside("right", {14, 0}), "right");
}

TEST(Grips, WhatIsSeenOfAnother_WinsOverTheRingOfTheSelected) {
  const Seen seen{{{point("A", {0, 0, 0}), point("B", {0, q(3, 5), 0})}}, "A"};
  EXPECT_LT(glm::distance(seen.pixelOf("A"), seen.pixelOf("B")), modeRingRadius + 5);
  EXPECT_EQ(seen.beside("B", {0, 0}), "B");
  EXPECT_EQ(seen.beside("B", {9, 0}), "B");
}

TEST(Grips, OfAnArrow_AreItsHeadUpToTheNeck) {
  const Seen seen{{{{"L", RayObject{{0, -6, 0}, {0, 8, 0}}}}}};
  EXPECT_EQ(seen.beside("L.r", {0, 0}), "L.r");
  EXPECT_EQ(seen.beside("L.r", {-30, 0}), "L.r") << "on its axis";
  EXPECT_EQ(seen.beside("L.r", {-35, 9}), "L.r") << "near its neck it is as wide";
  EXPECT_EQ(seen.beside("L.r", {-3, 9}), "") << "and at its tip it is not";
  EXPECT_EQ(seen.beside("L.r", {-70, 0}), "") << "the shaft is no handle";
}

TEST(Grips, OfAnArrowWithoutLength_LieInFrontOfItsStart) {
  const Seen seen{{{{"L", RayObject{{0, 0, 0}, {0, 0, 0}}}}}};
  EXPECT_EQ(seen.beside("L.r", {0, 0}), "L.r") << "so it can be drawn out again";
  EXPECT_EQ(seen.beside("L.Q", {9, 0}), "L.Q");
}

TEST(Grips, OfAKnob_AreItsBallAndItsArrows) {
  const Seen seen{{{{"E", PlaneObject{{0, 0, 0}, {0, 0, 2}}}}}};
  EXPECT_EQ(seen.beside("E.offset", {0, 0}), "E.offset");
  EXPECT_EQ(seen.beside("E.offset", {0, -20}), "E.offset");
  EXPECT_EQ(seen.beside("E.offset", {14, 0}), "");
}

TEST(Grips, OfWhatCannotBeGrabbedFromHere_AreNone) {
  Seen seen{{{{"E", PlaneObject{{0, 0, 0}, {1, 0, 0}}}}}};
  seen.view.camera.elevation = 0.05; // the eye looks along the normal
  EXPECT_EQ(seen.beside("E.offset", {0, 0}), "");
}

TEST(Grips, OnTwiceTheDesignPixels_AreTwiceAsLarge) {
  Seen seen{{{point("A", {0, 0, 0})}}, "A"};
  seen.view.pixelRatio = 2;
  EXPECT_EQ(seen.beside("A", {0, -2 * modeRingRadius + 1}), "A");
  EXPECT_EQ(seen.beside("A", {0, -2 * modeRingRadius - 2 * grabMargin - 1}), "");
}

} // namespace
} // namespace halfspace
