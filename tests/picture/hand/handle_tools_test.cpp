// The tools of handles: how they say that a handle moves, and what comes first under the pointer.
#include "widgets/picture/hand/handle_tools.h"

#include "lessons/pseudo_language.h"
#include "tests/lessons/scenes.h"
#include "tests/lessons/spoken_to_in.h"
#include "widgets/picture/shapes/gizmo_shape.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

TEST(GizmoOf, AHandleThatCannotBeGrabbed_HasNoWayToMove) {
  const Gizmo gizmo = gizmoOf(handle({{pointQ()}}, "Q"), {});
  EXPECT_EQ(gizmo.mode, Gizmo::Mode::None);
  EXPECT_FALSE(gizmo.axes);
  EXPECT_EQ(gizmo.at, Place(11, 15, 8));
}

TEST(GizmoOf, AHandle_ShowsHowItMoves) {
  const Handle point = handle({{pointQ()}}, "Q");
  EXPECT_EQ(gizmoOf(point, DragMode::Horizontal).mode, Gizmo::Mode::Horizontal);
  EXPECT_EQ(gizmoOf(point, DragMode::AxisZ).mode, Gizmo::Mode::AlongZ);
  EXPECT_TRUE(gizmoOf(point, DragMode::AxisZ).axes);
  const Gizmo offset = gizmoOf(handle({{planeE()}}, "E.offset"), DragMode::OwnAxis);
  EXPECT_EQ(offset.mode, Gizmo::Mode::AlongAxis);
  EXPECT_FALSE(offset.axes);
  EXPECT_EQ(offset.axis, Place(1, 2, 2));
}

TEST(FixedNote, OfATip_TellsTheArrowsOwnNumber) {
  const Scene scene{{rayL()}};
  const Evaluation evaluation = evaluate(scene);
  EXPECT_EQ(fixedNote(handle(scene, "L.Q"), scene, evaluation), "\\text{$\\displaystyle z = 8$ fixed}");
  EXPECT_EQ(fixedNote(handle(scene, "L.r"), scene, evaluation), "\\text{$\\displaystyle r_z = 2$ fixed}");
}

TEST(FixedNote, InAnotherLanguage_HasItsWordsAroundTheNumber) {
  const Scene scene{{rayL()}};
  const Evaluation evaluation = evaluate(scene);
  const SpokenToIn nobody(pseudoLanguage());
  EXPECT_EQ(fixedNote(handle(scene, "L.Q"), scene, evaluation),
            "\\text{⟦$\\displaystyle z = 8$ fíxéd ~~~~~⟧}");
}

TEST(KnobsOf, AreOfHandlesWithoutAMark_LargerWhereTheHandIs) {
  HandleSelection selection;
  selection.take(handlesOf(Scene{{planeE(), pointQ()}}));
  std::vector<Knob> knobs = knobsOf(selection, Camera());
  ASSERT_EQ(knobs.size(), 1U);
  EXPECT_EQ(knobs.front().id, "E.offset");
  EXPECT_FALSE(knobs.front().hot);
  selection.hover("E.offset");
  EXPECT_TRUE(knobsOf(selection, Camera()).front().hot);
}

TEST(TouchedAt, AHandleComesBeforeTheTool_AndTheToolBeforeAHandleThatIsJustMissed) {
  HandleSelection selection;
  selection.take(handlesOf(Scene{{{"A", PointObject{{0, 0, 0}}}}}));
  selection.select("A");
  View view;
  view.size = {800, 800};
  const std::vector<Grip> grips =
      gripsOf(selection.handles(), "A", figureOf(evaluate(Scene{{{"A", PointObject{{0, 0, 0}}}}})),
              themes().front(), view);
  const std::optional<Gizmo> tool = gizmoOf(*selection.selected(), DragMode::Horizontal);
  const glm::dvec2 middle(view.camera.project({}, view.size).value());
  EXPECT_EQ(touchedAt(middle, selection, grips, tool, view).handle, selection.find("A"));
  // The arrow along z begins where the ring ends; a hand that just misses the ball may be there too.
  const glm::dvec2 arrow = middle - glm::dvec2(0, modeRingRadius + 2);
  EXPECT_EQ(touchedAt(arrow, selection, grips, tool, view).part, Gizmo::Part::AxisZ);
  EXPECT_EQ(touchedAt(arrow, selection, grips, {}, view).handle, selection.find("A"));
  const Touched beside = touchedAt(middle - glm::dvec2(0, 200), selection, grips, tool, view);
  EXPECT_FALSE(beside.handle || beside.part);
}

} // namespace
} // namespace halfspace
