// What was done to a scene, undone and done again, and the gestures that do it.
#include "lessons/scene/history.h"

#include "tests/lessons/scene/random_edits.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

Edit moved(const std::string &point, int x) { return ChangeObject{point, PointObject{{x, 2, 3}}}; }

History distanceHistory() { return History({"signed-distance", 0, distanceScene()}); }

Rational placeOf(const History &history, const std::string &point) {
  return (*findObject(history.session().scene, point))[0].x;
}

TEST(History, RandomEdits_UndoneAndRedone_GiveEqualScenes) {
  constexpr int edits = 300;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    History history = distanceHistory();
    RandomEdits random(seed);
    std::vector<Scene> scenes{history.session().scene};
    for (int i = 0; i < edits; ++i) {
      const Scene before = history.session().scene;
      const auto refused = history.edit({random.next(before)}, "edit");
      if (refused)
        EXPECT_EQ(history.session().scene, before);
      else if (!(history.session().scene == before))
        scenes.push_back(history.session().scene);
    }
    ASSERT_EQ(history.count(), static_cast<int>(scenes.size()) - 1);
    for (std::size_t i = scenes.size() - 1; i-- > 0;) {
      ASSERT_TRUE(history.undo());
      EXPECT_EQ(history.session().scene, scenes[i]) << seed;
    }
    EXPECT_FALSE(history.undo());
    for (std::size_t i = 1; i < scenes.size(); ++i) {
      ASSERT_TRUE(history.redo());
      EXPECT_EQ(history.session().scene, scenes[i]) << seed;
    }
    EXPECT_FALSE(history.redo());
  }
}

TEST(History, OfAnEdit_KeepsWhatTheEditChanged_AndSharesAllElse) {
  History history = distanceHistory();
  const Scene before = history.session().scene;
  ASSERT_FALSE(history.edit({moved("Q", 1)}, "Move Q"));
  ASSERT_TRUE(history.undo());
  const Scene &back = history.session().scene;
  for (std::size_t place = 0; place < before.entries.size(); ++place)
    EXPECT_EQ(back.entries.shared(place), before.entries.shared(place)) << place;
  ASSERT_TRUE(history.redo());
  const Scene &again = history.session().scene;
  EXPECT_EQ(again.entries.shared(0), before.entries.shared(0));
  EXPECT_NE(again.entries.shared(1), before.entries.shared(1));
  EXPECT_EQ(again.entries.shared(2), before.entries.shared(2));
}

TEST(History, OfALabelThatIsDragged_IsOneStep_ThatTheSceneGoesBackFrom) {
  History history = distanceHistory();
  const GestureToken token = history.beginGesture("Move a label");
  for (const double x : {1.0, 2.0, 3.0})
    EXPECT_TRUE(history.moveGesture(token, ChangeLabel{"Q", LabelByHand{LabelSpot{{x, 1}}}}));
  history.endGesture(token);
  EXPECT_EQ(history.count(), 1);
  EXPECT_FALSE(history.isClean()) << "it is to be saved";
  EXPECT_EQ(history.session().scene.labels.at("Q").spot->offset.x, 3);
  ASSERT_TRUE(history.undo());
  EXPECT_TRUE(history.session().scene.labels.empty());
  ASSERT_TRUE(history.redo());
  EXPECT_FALSE(history.session().scene.labels.empty());
}

TEST(History, UndoneAndEdited_ForgetsWhatWasUndone) {
  History history = distanceHistory();
  ASSERT_FALSE(history.edit({moved("Q", 1)}, "first"));
  ASSERT_FALSE(history.edit({moved("Q", 2)}, "second"));
  ASSERT_TRUE(history.undo());
  EXPECT_EQ(history.undoText(), "first");
  EXPECT_EQ(history.redoText(), "second");
  EXPECT_EQ(history.count(), 2);
  ASSERT_FALSE(history.edit({moved("Q", 3)}, "third"));
  EXPECT_EQ(history.count(), 2);
  EXPECT_FALSE(history.redoText());
  EXPECT_EQ(history.text(1), "third");
}

TEST(History, OfEditsTogether_IsOneStep_OrNoneWhereOneIsRefused) {
  History history = distanceHistory();
  const Scene start = history.session().scene;
  const auto refused = history.edit({moved("Q", 1), RemoveEntry{"Q"}}, "both");
  ASSERT_TRUE(refused);
  EXPECT_FALSE(refused->sentence.empty());
  EXPECT_EQ(history.session().scene, start);
  EXPECT_EQ(history.count(), 0);
  ASSERT_FALSE(history.edit({moved("Q", 1), RenameEntry{"Q", "S"}}, "both"));
  EXPECT_EQ(history.count(), 1);
  history.undo();
  EXPECT_EQ(history.session().scene, start);
}

TEST(History, OfAnEditThatChangesNothing_HasNoStep) {
  History history = distanceHistory();
  ASSERT_FALSE(history.edit({ChangeObject{"Q", *findObject(history.session().scene, "Q")}}, "nothing"));
  EXPECT_EQ(history.count(), 0);
}

TEST(History, GoneBackIn_KeepsTheStepAndTheView) {
  History history = distanceHistory();
  ASSERT_FALSE(history.edit({moved("Q", 1)}, "Move Q"));
  Session elsewhere = history.session();
  elsewhere.step = 3;
  elsewhere.view = ChosenView();
  history.goTo(elsewhere);
  EXPECT_EQ(history.count(), 1);
  history.undo();
  EXPECT_EQ(history.session().step, 3);
  EXPECT_TRUE(history.session().view);
  EXPECT_EQ(placeOf(history, "Q"), 11);
}

TEST(History, SavedAndEdited_IsCleanWhereverTheEditIsUndone) {
  History history = distanceHistory();
  EXPECT_TRUE(history.isClean());
  ASSERT_FALSE(history.edit({moved("Q", 1)}, "first"));
  EXPECT_FALSE(history.isClean());
  history.setClean();
  ASSERT_FALSE(history.edit({moved("Q", 2)}, "second"));
  history.undo();
  EXPECT_TRUE(history.isClean());
  history.undo();
  EXPECT_FALSE(history.isClean());
  history.redo();
  EXPECT_TRUE(history.isClean());
}

TEST(History, WhoseSavedStateWasUndoneAndEditedAway_IsNeverCleanAgain) {
  History history = distanceHistory();
  ASSERT_FALSE(history.edit({moved("Q", 1)}, "first"));
  history.setClean();
  history.undo();
  ASSERT_FALSE(history.edit({moved("Q", 2)}, "another"));
  EXPECT_FALSE(history.isClean()) << "as many steps, but others";
  history.undo();
  EXPECT_FALSE(history.isClean());
}

TEST(History, SavedNowhere_IsNotCleanBeforeItIsSaved) {
  History history = distanceHistory();
  history.resetClean();
  EXPECT_FALSE(history.isClean());
  ASSERT_FALSE(history.edit({moved("Q", 1)}, "first"));
  history.undo();
  EXPECT_FALSE(history.isClean());
  history.setClean();
  EXPECT_TRUE(history.isClean());
}

TEST(History, Cleared_KeepsItsSession_AndIsClean) {
  History history = distanceHistory();
  ASSERT_FALSE(history.edit({moved("Q", 1)}, "first"));
  history.clear();
  EXPECT_EQ(history.count(), 0);
  EXPECT_TRUE(history.isClean());
  EXPECT_EQ(placeOf(history, "Q"), 1);
}

TEST(Gesture, MovedOften_IsOneStep) {
  History history = distanceHistory();
  const GestureToken held = history.beginGesture("Move Q");
  for (const int x : {1, 2, 3})
    EXPECT_TRUE(history.moveGesture(held, moved("Q", x)));
  EXPECT_FALSE(history.moveGesture(held, moved("Q", 3))) << "it is there already";
  EXPECT_EQ(history.count(), 0);
  EXPECT_EQ(history.movedByGesture(), std::vector<std::string>{"Q"});
  history.endGesture(held);
  EXPECT_EQ(history.count(), 1);
  EXPECT_EQ(history.undoText(), "Move Q");
  history.undo();
  EXPECT_EQ(placeOf(history, "Q"), 11);
}

TEST(Gesture, ThatCameBackToWhereItBegan_IsNoStep) {
  History history = distanceHistory();
  const GestureToken held = history.beginGesture("Move Q");
  history.moveGesture(held, moved("Q", 1));
  history.moveGesture(held, ChangeObject{"Q", PointObject{{11, 15, 8}}});
  EXPECT_TRUE(history.movedByGesture().empty());
  history.endGesture(held);
  EXPECT_EQ(history.count(), 0);
}

TEST(Gesture, Rewound_GoesOnFromWhereItBegan) {
  History history = distanceHistory();
  const GestureToken held = history.beginGesture("Move Q");
  history.moveGesture(held, moved("Q", 1));
  history.rewindGesture(held);
  EXPECT_EQ(placeOf(history, "Q"), 11);
  EXPECT_TRUE(history.isHeldBy(held));
  history.endGesture(held);
  EXPECT_EQ(history.count(), 0);
}

TEST(Gesture, ThatAnotherTokenHolds_IsNeitherMovedNorRewoundNorEnded) {
  History history = distanceHistory();
  const GestureToken first = history.beginGesture("first");
  history.moveGesture(first, moved("Q", 1));
  const GestureToken second = history.beginGesture("second"); // ends the first, as it is
  EXPECT_EQ(history.count(), 1);
  EXPECT_FALSE(history.moveGesture(first, moved("Q", 9)));
  history.rewindGesture(first);
  history.endGesture(first);
  EXPECT_TRUE(history.isHeldBy(second));
  EXPECT_EQ(placeOf(history, "Q"), 1);
  EXPECT_FALSE(history.moveGesture(GestureToken::Nobodys, moved("Q", 9)));
}

TEST(Gesture, ThatGoesOn_IsEndedAsItIs_ByWhateverElseChangesTheScene) {
  const auto afterAll = [](auto change) {
    History history = distanceHistory();
    EXPECT_FALSE(history.edit({moved("Q", 4)}, "before"));
    const GestureToken held = history.beginGesture("held");
    history.moveGesture(held, moved("Q", 1));
    change(history);
    EXPECT_FALSE(history.inGesture());
    EXPECT_EQ(history.text(1), "held");
    return history;
  };
  EXPECT_EQ(placeOf(afterAll([](History &history) { history.undo(); }), "Q"), 4);
  EXPECT_EQ(placeOf(afterAll([](History &history) { history.redo(); }), "Q"), 1);
  EXPECT_EQ(afterAll([](History &history) {
              EXPECT_FALSE(history.edit({RenameEntry{"Q", "S"}}, "rename"));
            }).count(),
            3);
  EXPECT_EQ(afterAll([](History &history) { history.replaceScene(distanceScene(), "Start over"); }).count(),
            3);
}

TEST(Gesture, Dropped_LeavesNoStep_AndItsTokenHoldsNoLaterOne) {
  History history = distanceHistory();
  const GestureToken held = history.beginGesture("held");
  history.dropGesture();
  EXPECT_FALSE(history.inGesture());
  const GestureToken next = history.beginGesture("next");
  EXPECT_FALSE(history.isHeldBy(held));
  EXPECT_TRUE(history.isHeldBy(next));
}

TEST(History, OfAReplacedScene_TellsThatAllOfItIsAnotherOne) {
  History history = distanceHistory();
  ASSERT_FALSE(history.edit({moved("Q", 1)}, "Move Q"));
  history.replaceScene(distanceScene(), "Start over");
  EXPECT_EQ(placeOf(history, "Q"), 11);
  EXPECT_TRUE(history.undo()->replaces);
  EXPECT_FALSE(history.undo()->replaces);
}

} // namespace
} // namespace halfspace
