// What is drawn for the hand: as large on the screen however near the camera is, and where it belongs.
#include "tests/picture/shapes/mesh_of.h"
#include "widgets/picture/shapes/tool_shapes.h"

#include "widgets/picture/shapes/gizmo_shape.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace halfspace {
namespace {

const Place at(2, 3, 4);

const Theme &theme() { return themes().front(); }

View viewAtHeight(double height, double pixelRatio = 1) {
  View view;
  view.camera.target = at;
  view.camera.azimuth = 0.7;
  view.camera.elevation = 0.6;
  view.camera.height = height;
  view.size = {1280, 800};
  view.pixelRatio = pixelRatio;
  return view;
}

SceneContent withGizmo(Gizmo::Mode mode, bool axes = false) {
  SceneContent content;
  content.gizmo.emplace();
  content.gizmo->at = at;
  content.gizmo->axes = axes;
  content.gizmo->mode = mode;
  return content;
}

SceneContent withKnob(std::optional<Place> axis, bool hot = false) {
  SceneContent content;
  content.knobs.push_back({"k", at, axis, Subject::Plane, hot});
  return content;
}

Mesh toolsMesh(const SceneContent &content, const View &view = viewAtHeight(21)) {
  return meshOf(toolsOf(content, theme(), view));
}

/// How far a mesh reaches from the tool's place along each axis, both ways together.
Place reachOf(const Mesh &mesh) {
  Place low(std::numeric_limits<double>::infinity());
  Place high(-low);
  for (const glm::vec3 &position : mesh.positions) {
    low = glm::min(low, Place(position));
    high = glm::max(high, Place(position));
  }
  return high - low;
}

Place reachOf(const SceneContent &content, const View &view = viewAtHeight(21)) {
  return reachOf(toolsMesh(content, view));
}

bool hasColor(const Mesh &mesh, Color color) {
  return std::find(mesh.colors.begin(), mesh.colors.end(), color) != mesh.colors.end();
}

struct ModeShown {
  const char *name;
  Gizmo::Mode mode;
  Place along; ///< 1 for each axis that it is long in
};

struct EveryMode : testing::TestWithParam<ModeShown> {};

TEST_P(EveryMode, OfTheGizmo_IsDrawnAlongTheWayThatItMoves) {
  const Place reach = reachOf(withGizmo(GetParam().mode));
  const double longest = std::max({reach.x, reach.y, reach.z});
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_EQ(reach[axis] > 0.5 * longest, GetParam().along[axis] == 1) << "xyz"[axis];
}

INSTANTIATE_TEST_SUITE_P(Gizmo, EveryMode,
                         testing::Values(ModeShown{"Horizontal", Gizmo::Mode::Horizontal, {1, 1, 0}},
                                         ModeShown{"Vertical", Gizmo::Mode::Vertical, {0, 0, 1}},
                                         ModeShown{"AlongX", Gizmo::Mode::AlongX, {1, 0, 0}},
                                         ModeShown{"AlongY", Gizmo::Mode::AlongY, {0, 1, 0}},
                                         ModeShown{"AlongZ", Gizmo::Mode::AlongZ, {0, 0, 1}}),
                         [](const auto &each) { return std::string(each.param.name); });

TEST(Tools, OfAHandleWithAnAxis_AreDrawnAlongIt) {
  SceneContent content = withGizmo(Gizmo::Mode::AlongAxis);
  EXPECT_TRUE(toolsMesh(content).positions.empty()) << "there is no axis yet";
  content.gizmo->axis = Place(0, 50, 0);
  const Place reach = reachOf(content);
  EXPECT_GT(reach.y, 3 * reach.x);
  content.gizmo->mode = Gizmo::Mode::None; // it cannot be grabbed from here, but is told of
  EXPECT_EQ(reachOf(content), reach);
  EXPECT_FALSE(hasColor(toolsMesh(content), theme().accent));
}

TEST(Tools, WhereverTheCameraIs_HaveOneSizeOnTheScreen) {
  for (const SceneContent &content : {withGizmo(Gizmo::Mode::Horizontal, true), withKnob({})}) {
    const Place near = reachOf(content, viewAtHeight(7));
    EXPECT_NEAR(glm::distance(reachOf(content, viewAtHeight(21)), near * 3.0), 0, 1e-3);
    EXPECT_NEAR(glm::distance(reachOf(content, viewAtHeight(7, 2)), near * 2.0), 0, 1e-3);
  }
}

TEST(Tools, OfAGizmoWithAxes_ReachAsFarAsTheyAreHit) {
  const View view = viewAtHeight(21);
  const double unit = view.unitsPerDesignPixel(at);
  const Place reach = reachOf(withGizmo(Gizmo::Mode::None, true));
  for (int axis = 0; axis < 3; ++axis) {
    const double end = gizmoArrowStart + gizmoArrowLength;
    EXPECT_GT(reach[axis], end * unit - 1e-6);
    EXPECT_LT(reach[axis], 1.2 * end * unit);
  }
}

TEST(Tools, ThePartUnderThePointer_IsInTheAccentsColour) {
  SceneContent content = withGizmo(Gizmo::Mode::None, true);
  EXPECT_FALSE(hasColor(toolsMesh(content), theme().accent));
  for (const Gizmo::Part part : {Gizmo::Part::AxisX, Gizmo::Part::PlaneYZ}) {
    content.gizmo->hot = part;
    EXPECT_TRUE(hasColor(toolsMesh(content), theme().accent));
  }
}

TEST(Tools, OfAKnob_AreADoubleArrowOrACrossOnTheScreen) {
  const Place along = reachOf(withKnob(Place(0, 0, 3)));
  EXPECT_GT(along.z, 2 * along.x);
  const View view = viewAtHeight(21);
  const Mesh cross = toolsMesh(withKnob({}), view);
  double sideways = 0;
  double upward = 0;
  double toEye = 0;
  for (const glm::vec3 &position : cross.positions) {
    const Place way = Place(position) - at;
    sideways = std::max(sideways, glm::dot(way, view.camera.right()));
    upward = std::max(upward, glm::dot(way, view.camera.up()));
    toEye = std::max(toEye, std::abs(glm::dot(way, view.camera.viewDirection())));
  }
  EXPECT_NEAR(sideways, upward, 1e-3);
  EXPECT_LT(toEye, 0.5 * upward);
}

TEST(Tools, OfAKnobOfAnObjectInALook_HaveItsColour) {
  SceneContent content = withKnob({});
  PlanePatchMark whole;
  whole.id = content.knobs.front().id.substr(0, content.knobs.front().id.find('.'));
  whole.look.hue = Hue::Green;
  content.figure.add(std::move(whole));
  EXPECT_TRUE(hasColor(toolsMesh(content), theme().colorOf(Hue::Green)));
}

TEST(Tools, OfAHotKnob_AreLargerAndInTheAccentsColour) {
  EXPECT_GT(reachOf(withKnob({}, true)).z, 1.3 * reachOf(withKnob({})).z);
  EXPECT_TRUE(hasColor(toolsMesh(withKnob({}, true)), theme().accent));
  EXPECT_TRUE(hasColor(toolsMesh(withKnob({})), theme().colorOf(Subject::Plane)));
}

TEST(Tools, OfADropLine_GoDownToTheGroundAndOnToTheAxes) {
  SceneContent content;
  content.dropLine = DropLine{at};
  const auto touches = [&](const Place &place) {
    const Mesh mesh = toolsMesh(content);
    return std::any_of(mesh.positions.begin(), mesh.positions.end(),
                       [&](const glm::vec3 &p) { return glm::distance(Place(p), place) < 0.1; });
  };
  EXPECT_TRUE(touches(at) && touches({2, 3, 0}));
  EXPECT_TRUE(touches({2, 0, 0}) && touches({0, 3, 0}));
  content.stage.middle = {1000, 0, 0}; // its axes lie elsewhere
  EXPECT_TRUE(touches(at) && touches({2, 3, 0}));
  EXPECT_FALSE(touches({2, 0, 0}) || touches({0, 3, 0}));
}

TEST(Tools, BehindTheEye_AreNotDrawn) {
  SceneContent content = withGizmo(Gizmo::Mode::Horizontal, true);
  const Place behind = viewAtHeight(21).camera.eye() - viewAtHeight(21).camera.viewDirection() * 5.0;
  content.gizmo->at = behind;
  content.knobs.push_back({"k", behind, {}, Subject::Plane, false});
  EXPECT_TRUE(toolsMesh(content).positions.empty());
}

} // namespace
} // namespace halfspace
