// A drag from press to release: which way a handle may be moved, and the exact numbers it comes to.
#include "widgets/picture/hand/handle_drag.h"

#include "tests/lessons/scenes.h"
#include "widgets/picture/shapes/gizmo_shape.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <numbers>

namespace halfspace {
namespace {

using namespace test;

constexpr double straightDown = std::numbers::pi / 2;

/// Looks at a place from the side of +x and +y, so many radians downward.
View viewOf(const Place &target, double elevation = 0.6, double azimuth = 0.7) {
  View view;
  view.camera.target = target;
  view.camera.azimuth = azimuth;
  view.camera.elevation = elevation;
  view.size = {1280, 800};
  return view;
}

glm::dvec2 pixelOf(const View &view, const Place &place) {
  return glm::dvec2(view.camera.project(place, view.size).value());
}

Handle handleOf(const Entry &entry, const std::string &id) { return handle(Scene{{entry}}, id); }

Entry box() {
  Object object = *makeObject("box");
  object[1].x = 3;
  return {"B", object};
}

/// Drags a handle of a scene in one mode, looked at from nearby.
struct Dragging {
  Scene scene;
  std::string id;
  DragMode mode = DragMode::Horizontal;
  Rational step = 1;
  View view = viewOf(shownPlace(handle(scene, id)));
  HandleDrag drag{scene, handle(scene, id), mode, pixelOf(view, shownPlace(handle(scene, id)))};

  /// Moves the pointer to where the handle would be drawn after this way.
  std::optional<DragMove> by(const Place &way) {
    return drag.moveTo(pixelOf(view, shownPlace(handle(scene, id)) + way), step, view);
  }
  ExactVec3 reached(const Place &way) {
    const auto move = by(way);
    EXPECT_TRUE(move);
    return move ? move->object[handle(scene, id).coordinate] : ExactVec3(-999);
  }
};

TEST(GrabMode, OfAFreeHandle_IsWhatWasWishedWhereTheCameraLetsIt) {
  const Handle free = handleOf(pointQ(), "Q");
  const Place at(11, 15, 8);
  EXPECT_EQ(grabMode(free, false, viewOf(at).camera), DragMode::Horizontal);
  EXPECT_EQ(grabMode(free, true, viewOf(at).camera), DragMode::Vertical);
  EXPECT_EQ(grabMode(free, false, viewOf(at, 0.05).camera), DragMode::Vertical) << "seen flat";
  EXPECT_EQ(grabMode(free, true, viewOf(at, straightDown - 0.05).camera), DragMode::Horizontal)
      << "seen from above";
}

TEST(GrabMode, OfAHandleWithAnAxis_IsThatAxisOrNothing) {
  const Handle offset = handleOf(planeE(), "E.offset");
  const Place at = shownPlace(offset);
  EXPECT_EQ(grabMode(offset, true, viewOf(at).camera), DragMode::OwnAxis);
  const Place along = glm::normalize(Place(1, 2, 2));
  View endOn = viewOf(at, std::asin(along.z), std::atan2(along.y, along.x));
  EXPECT_FALSE(grabMode(offset, false, endOn.camera));
}

TEST(ShownPlace, OfAPlanesOffset_IsBesideItsPointInThePlane) {
  const Handle offset = handleOf(planeE(), "E.offset");
  const Place way = shownPlace(offset) - Place(5, 4, 7);
  EXPECT_GT(glm::length(way), 3);
  EXPECT_NEAR(way.z, 0, 1e-12);
  EXPECT_NEAR(glm::dot(way, Place(1, 2, 2)), 0, 1e-12);
  const Handle level = handleOf({"E", PlaneObject{{5, 4, 7}, {0, 0, 1}}}, "E.offset");
  EXPECT_GT(glm::distance(shownPlace(level), Place(5, 4, 7)), 3) << "a level plane has no such direction";
}

TEST(ShownPlace, OfOtherHandles_IsWhereTheyAre) {
  EXPECT_EQ(shownPlace(handleOf(pointQ(), "Q")), Place(11, 15, 8));
  EXPECT_EQ(shownPlace(handleOf(rayL(), "L.r")), Place(10, 18, 10));
  EXPECT_EQ(shownPlace(handleOf(box(), "B.a")), Place(3, 0, 0));
}

TEST(KnobOf, HandlesThatNoMarkShows_AreKnobsAndOthersAreNone) {
  EXPECT_FALSE(knobOf(handleOf(pointQ(), "Q"), false));
  EXPECT_FALSE(knobOf(handleOf(rayL(), "L.r"), true));
  EXPECT_EQ(knobOf(handleOf(planeE(), "E.offset"), false)->axis, Place(1, 2, 2));
  EXPECT_EQ(knobOf(handleOf(box(), "B.b"), false)->axis, Place(0, 1, 0));
  const auto whole = knobOf(handleOf(triangleT(), "T.whole"), true);
  ASSERT_TRUE(whole);
  EXPECT_FALSE(whole->axis) << "it moves every way";
  EXPECT_TRUE(whole->hot);
  EXPECT_EQ(whole->id, "T.whole");
}

struct Freedom {
  const char *name;
  Gizmo::Part part;
  Place moves; ///< 1 for each coordinate that may change
};

struct EveryPart : testing::TestWithParam<Freedom> {};

TEST_P(EveryPart, OfTheGizmo_MovesItsCoordinatesAloneToTheGridPlaceUnderThePointer) {
  const Place moves = GetParam().moves;
  Dragging dragging{Scene{{pointQ()}}, "Q", modeOf(GetParam().part)};
  EXPECT_EQ(toDouble(dragging.reached(moves * Place(2, -1, 3))), Place(11, 15, 8) + moves * Place(2, -1, 3));
  const Place elsewhere = toDouble(dragging.reached({-3, 4, 2}));
  for (int axis = 0; axis < 3; ++axis) {
    const double change = elsewhere[axis] - Place(11, 15, 8)[axis];
    EXPECT_TRUE(moves[axis] == 1 || change == 0) << "xyz"[axis];
  }
}

INSTANTIATE_TEST_SUITE_P(Gizmo, EveryPart,
                         testing::Values(Freedom{"X", Gizmo::Part::AxisX, {1, 0, 0}},
                                         Freedom{"Y", Gizmo::Part::AxisY, {0, 1, 0}},
                                         Freedom{"Z", Gizmo::Part::AxisZ, {0, 0, 1}},
                                         Freedom{"XY", Gizmo::Part::PlaneXY, {1, 1, 0}},
                                         Freedom{"YZ", Gizmo::Part::PlaneYZ, {0, 1, 1}},
                                         Freedom{"ZX", Gizmo::Part::PlaneZX, {1, 0, 1}}),
                         [](const auto &each) { return std::string(each.param.name); });

TEST(HandleDrag, ByAFinerStep_RoundsToIt) {
  Dragging dragging{Scene{{pointQ()}}, "Q", DragMode::Horizontal, q(1, 4)};
  EXPECT_EQ(dragging.reached({0.7, 0.3, 0}), ExactVec3(q(47, 4), q(61, 4), 8));
}

TEST(HandleDrag, OfAPlanesOffset_MovesItsPointAlongTheNormal) {
  Dragging dragging{Scene{{planeE()}}, "E.offset", DragMode::OwnAxis};
  const auto move = dragging.by({2, 4, 4});
  ASSERT_TRUE(move);
  EXPECT_EQ(move->object, Object(PlaneObject{{7, 8, 11}, {1, 2, 2}}));
}

TEST(HandleDrag, OfALength_MeasuresFromItsCorner) {
  Dragging dragging{Scene{{box()}}, "B.a", DragMode::OwnAxis};
  EXPECT_EQ(dragging.reached({2, 0, 0}).x, 5);
}

TEST(HandleDrag, OfADirection_KeepsItsStart) {
  Dragging dragging{Scene{{rayL()}}, "L.r"};
  const auto move = dragging.by({2, -1, 0});
  ASSERT_TRUE(move);
  EXPECT_EQ(move->object, Object(RayObject{{11, 15, 8}, {1, 2, 2}}));
}

TEST(HandleDrag, ThatGoesOnInAnotherMode_StartsFromWhereItIs) {
  Dragging dragging{Scene{{pointQ()}}, "Q"};
  EXPECT_EQ(dragging.reached({-4, -2, 0}), ExactVec3(7, 13, 8));
  dragging.drag.setMode(DragMode::AxisZ);
  EXPECT_EQ(dragging.reached({-4, -2, 0}), ExactVec3(7, 13, 8)) << "the pointer has not moved since";
  EXPECT_EQ(dragging.reached({-4, -2, 3}), ExactVec3(7, 13, 11));
}

TEST(HandleDrag, FarAway_EndsAtTheBoxOfTheStage) {
  Dragging dragging{Scene{{pointQ()}}, "Q", DragMode::AxisX};
  EXPECT_EQ(dragging.reached({60, 0, 0}).x, int(dragBox));
  Dragging outside{Scene{{{"Q", PointObject{{50, 0, 0}}}}}, "Q", DragMode::AxisX};
  EXPECT_EQ(outside.reached({12, 0, 0}).x, 50) << "no farther out than it is";
  EXPECT_EQ(outside.reached({-12, 0, 0}).x, 38);
}

TEST(HandleDrag, NearAPlane_ComesToRestExactlyOnItAndSaysSo) {
  Dragging dragging{Scene{{planeE(), {"Q", PointObject{{11, q(31, 2), 8}}}}}, "Q", DragMode::Vertical};
  const auto caught = dragging.by({0, 0, -15.45}); // 6 + 2·11.5 + 2(z − 7) = 0 at z = −7.5
  ASSERT_TRUE(caught);
  EXPECT_EQ(caught->object[0].z, q(-15, 2));
  EXPECT_EQ(caught->caught, "plane E");
}

TEST(HandleDrag, BeyondTheHorizon_GivesNothing) {
  Dragging dragging{Scene{{pointQ()}}, "Q"};
  EXPECT_FALSE(dragging.drag.moveTo({640, -3000}, 1, dragging.view));
}

} // namespace
} // namespace halfspace
