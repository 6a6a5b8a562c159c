#include "lessons/lesson/explore.h"

#include "lessons/lesson/shown.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

TEST(Explore, IsKnownToEveryLibrary_AndEmpty) {
  const Lesson *explore = LessonLibrary().find(exploreId);
  ASSERT_TRUE(explore);
  EXPECT_EQ(explore->scene.entries.size(), 0U);
  EXPECT_EQ(explore->steps.size(), 1U);
}

TEST(Explore, StepShowingAConstruction_HasItsLinesAlone_AllThatItDraws_AndTheResultsOfOthers) {
  Scene scene = test::distanceScene();
  scene.entries.push_back({"again", ConstructionUse{"signed-distance", {{"E", "E"}, {"Q", "distance.F"}}}});
  const Evaluation evaluation = evaluate(scene);
  const Shown shown = shownIn(stepShowing({"distance"}), evaluation);
  EXPECT_EQ(shown.working.lines.size(), evaluation.find("distance")->outcome->explanation->ids().size());
  for (const WorkingLine &line : shown.working.lines)
    EXPECT_EQ(entryOf(line.id), "distance");
  for (const Mark &mark : figureOf(evaluation).marks) {
    const MarkBase &base = baseOf(mark);
    const bool isShown = findMark(shown.figure, base.id) != nullptr;
    const bool isOfAgain = entryOfMark(base.id) == "again";
    EXPECT_EQ(isShown, !isOfAgain || base.role == Role::Given || base.role == Role::Result) << base.id;
  }
  EXPECT_EQ(shown.description, evaluation.find("distance")->outcome->told->description);
}

TEST(Explore, StepShowingNothing_HasNoLines_AndWhatIsGivenAndComesOut) {
  const Evaluation evaluation = evaluate(test::distanceScene());
  const Shown shown = shownIn(stepShowing({}), evaluation);
  EXPECT_TRUE(shown.working.lines.empty());
  EXPECT_TRUE(findMark(shown.figure, "Q"));
  EXPECT_TRUE(findMark(shown.figure, "distance.F"));
  EXPECT_FALSE(findMark(shown.figure, "distance.w"));
}

} // namespace
} // namespace halfspace
