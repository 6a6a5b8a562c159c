// Which handle is selected, which comes next, and what becomes of that where handles come and go.
#include "widgets/picture/hand/handle_selection.h"

#include "tests/lessons/scenes.h"
#include "tests/picture/marks.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

Handle handleOf(const std::string &id, ExactVec3 at = {}) {
  Handle handle;
  handle.id = handle.object = id;
  handle.at = at;
  return handle;
}

HandleSelection selectionOf(const std::vector<std::string> &ids, const std::string &selected = {}) {
  std::vector<Handle> handles;
  for (const std::string &id : ids)
    handles.push_back(handleOf(id));
  HandleSelection selection;
  selection.take(handles);
  selection.select(selected);
  return selection;
}

TEST(HandleSelection, Next_GoesFromHandleToHandle_AndBehindTheLastToNone) {
  EXPECT_EQ(selectionOf({"A", "B", "C"}).next(true), "A");
  EXPECT_EQ(selectionOf({"A", "B", "C"}, "B").next(true), "C");
  EXPECT_EQ(selectionOf({"A", "B", "C"}, "C").next(true), "");
  EXPECT_EQ(selectionOf({"A", "B", "C"}).next(false), "C");
  EXPECT_EQ(selectionOf({"A", "B", "C"}, "B").next(false), "A");
  EXPECT_EQ(selectionOf({"A", "B", "C"}, "A").next(false), "");
  EXPECT_EQ(selectionOf({}).next(true), "");
  EXPECT_EQ(selectionOf({}).next(false), "");
}

TEST(HandleSelection, OfHandlesThatComeAndGo_KeepsOnlyWhatIsThere) {
  HandleSelection selection = selectionOf({"A", "B"}, "A");
  selection.hover("B");
  selection.take({handleOf("C"), handleOf("A", {1, 2, 3})});
  ASSERT_TRUE(selection.selected());
  EXPECT_EQ(selection.selected()->at, ExactVec3(1, 2, 3));
  EXPECT_EQ(selection.hoveredId(), "");
  selection.take({handleOf("C")});
  EXPECT_EQ(selection.selectedId(), "");
  EXPECT_EQ(selection.selected(), nullptr);
}

TEST(HandleSelection, AnotherHandle_MovesInXAndYAtFirst) {
  HandleSelection selection = selectionOf({"A", "B"}, "A");
  selection.switchDirection();
  selection.select("A");
  EXPECT_TRUE(selection.isVertical());
  selection.select("B");
  EXPECT_FALSE(selection.isVertical());
}

TEST(HandleSelection, Mode_IsThatOfTheSelectedHandle) {
  HandleSelection selection;
  const Camera camera; // neither from above nor level: both can be grabbed
  selection.take(handlesOf(Scene{{pointQ()}}));
  EXPECT_EQ(selection.mode(camera), std::nullopt);
  selection.select("Q");
  EXPECT_EQ(selection.mode(camera), DragMode::Horizontal);
  selection.switchDirection();
  EXPECT_EQ(selection.mode(camera), DragMode::Vertical);
}

TEST(HandleSelection, TheHandIsAboutTheSelectedHandle_ElseTheHoveredOne) {
  HandleSelection selection = selectionOf({"A", "B"});
  EXPECT_EQ(selection.regarded(), nullptr);
  selection.hover("B");
  EXPECT_EQ(selection.regarded(), selection.find("B"));
  selection.select("A");
  EXPECT_EQ(selection.regarded(), selection.find("A"));
  EXPECT_TRUE(selection.isHot(*selection.find("A")));
  EXPECT_TRUE(selection.isHot(*selection.find("B")));
}

TEST(HandleOfBody, IsThePlaceOfAMesh_AndNoneOfOtherMarks) {
  std::vector<Handle> handles{handleOf("M"), handleOf("P")};
  handles.front().motion = Handle::Motion::Whole;
  Figure figure;
  figure.marks = {withId(MeshMark(), "M"), withId(pointAt({}), "P")};
  EXPECT_EQ(handleOfBody("M", figure, handles), nullptr) << "it is no place";
  handles.front().motion = Handle::Motion::Coordinate;
  EXPECT_EQ(handleOfBody("M", figure, handles), &handles.front());
  EXPECT_EQ(handleOfBody("P", figure, handles), nullptr);
}

TEST(MovedPositions, AreThosePlacesThatAreElsewhere_NoTips) {
  const auto before = handlesOf(Scene{{planeE(), pointQ()}});
  const Scene moved{{{"E", PlaneObject{{5, 4, 7}, {0, 0, 1}}}, {"Q", PointObject{{11, 15, 9}}}}};
  EXPECT_EQ(movedPositions(before, before), std::vector<Place>());
  EXPECT_EQ(movedPositions(before, handlesOf(moved)), (std::vector<Place>{{11, 15, 9}}));
  EXPECT_EQ(movedPositions({}, handlesOf(moved)), std::vector<Place>()) << "they are new";
}

} // namespace
} // namespace halfspace
