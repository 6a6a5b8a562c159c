#include "lessons/scene/edit.h"

#include "lessons/object/kind.h"
#include "lessons/object/kinds/number.h"
#include "lessons/reading/typed_number.h"
#include "lessons/scene/file/session_file.h"
#include "lessons/scene/scene_checker.h"
#include "tests/lessons/scene/random_edits.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace halfspace {
namespace {

using namespace test;

std::vector<std::string> namesOf(const Scene &scene) {
  std::vector<std::string> names;
  for (const Entry &entry : scene.entries)
    names.push_back(entry.name);
  return names;
}

/// Why an edit of the scene is refused; empty where it is not.
std::string refusal(const Scene &scene, const Edit &edit) {
  const auto edited = apply(scene, edit);
  return edited ? "" : edited.problem().sentence;
}

/// A distance, and that of its foot.
Scene chain() {
  Scene scene = distanceScene();
  scene.entries.push_back({"again", ConstructionUse{"signed-distance", {{"E", "E"}, {"Q", "distance.F"}}}});
  return scene;
}

TEST(ChangeObject, OfTheSameKind_ChangesOnlyThatObject) {
  const Scene after = edited(distanceScene(), {ChangeObject{"Q", PointObject{{1, 2, 3}}}});
  EXPECT_EQ(*findObject(after, "Q"), Object(PointObject{{1, 2, 3}}));
  EXPECT_EQ(*findObject(after, "E"), *findObject(distanceScene(), "E"));
}

TEST(ChangeObject, OfAnotherKindNoObjectOrATooLargeNumber_IsRefusedWithASentence) {
  EXPECT_EQ(refusal(distanceScene(), ChangeObject{"Q", PlaneObject{}}), "“Q” is a point and stays one.");
  EXPECT_EQ(refusal(distanceScene(), ChangeObject{"X", PointObject{}}), "There is no “X” in the scene.");
  EXPECT_NE(refusal(distanceScene(), ChangeObject{"distance", PointObject{}}), "");
  EXPECT_EQ(refusal(distanceScene(), ChangeObject{"Q", PointObject{{coordinateLimit + 1, 0, 0}}}),
            refuseCoordinate(coordinateLimit + 1).value());
}

TEST(AddEntry, InTheMiddleOrAtTheEnd_StandsThere) {
  const Entry point{"S", PointObject{}};
  EXPECT_EQ(namesOf(edited(distanceScene(), {AddEntry{1, point}})),
            (std::vector<std::string>{"E", "S", "Q", "distance"}));
  EXPECT_EQ(namesOf(edited(distanceScene(), {AddEntry{99, point}})).back(), "S");
}

TEST(AddEntry, WithATakenNameOrAboveWhatItLooksAt_IsRefused) {
  EXPECT_NE(refusal(distanceScene(), AddEntry{3, {"Q", PointObject{}}}), "");
  const Entry use{"again", ConstructionUse{"signed-distance", {{"E", "E"}, {"Q", "Q"}}}};
  EXPECT_EQ(refusal(distanceScene(), AddEntry{2, use}), "");
  EXPECT_EQ(refusal(distanceScene(), AddEntry{1, use}), "Above this entry there is no object “Q”.");
}

TEST(RemoveEntry, ThatOthersLookAt_IsRefusedOrTakesThemAlong) {
  EXPECT_EQ(refusal(chain(), RemoveEntry{"Q"}),
            "“Q” is needed by distance, again: remove them with it, or first.");
  EXPECT_EQ(namesOf(edited(chain(), {RemoveEntry{"Q", true}})), (std::vector<std::string>{"E"}));
  EXPECT_EQ(namesOf(edited(chain(), {RemoveEntry{"again"}})), namesOf(distanceScene()));
  EXPECT_NE(refusal(chain(), RemoveEntry{"X", true}), "");
}

TEST(RenameEntry, ThatOthersLookAt_IsFollowedByThem) {
  const Scene after = edited(chain(), {RenameEntry{"distance", "d"}, RenameEntry{"E", "G"}});
  const auto &use = std::get<ConstructionUse>(after.entries.back().content);
  EXPECT_EQ(use.roles.at("Q"), "d.F");
  EXPECT_EQ(use.roles.at("E"), "G");
  EXPECT_FALSE(checkScene(after));
}

TEST(RenameEntry, ToATakenNameOrNone_IsRefused) {
  EXPECT_NE(refusal(chain(), RenameEntry{"Q", "E"}), "");
  EXPECT_NE(refusal(chain(), RenameEntry{"Q", "2 b"}), "");
  EXPECT_NE(refusal(chain(), RenameEntry{"X", "Y"}), "");
  EXPECT_EQ(refusal(chain(), RenameEntry{"Q", "Q"}), "");
}

TEST(RebindRole, ToAnObjectOfTheKindAbove_LooksAtIt) {
  const Scene after = edited(chain(), {RebindRole{"again", "Q", "Q"}});
  EXPECT_EQ(std::get<ConstructionUse>(after.entries.back().content).roles.at("Q"), "Q");
  EXPECT_NE(refusal(chain(), RebindRole{"again", "Q", "E"}), "") << "of another kind";
  EXPECT_NE(refusal(chain(), RebindRole{"distance", "Q", "again.F"}), "") << "below it";
  EXPECT_NE(refusal(chain(), RebindRole{"again", "Z", "Q"}), "") << "no such role";
  EXPECT_NE(refusal(chain(), RebindRole{"Q", "Q", "Q"}), "") << "no construction";
}

TEST(MoveEntry, WithinWhatItLooksAtAndWhatLooksAtIt_StandsThere) {
  EXPECT_EQ(namesOf(edited(chain(), {MoveEntry{"Q", 0}})),
            (std::vector<std::string>{"Q", "E", "distance", "again"}));
  EXPECT_NE(refusal(chain(), MoveEntry{"distance", 1}), "");
  EXPECT_NE(refusal(chain(), MoveEntry{"E", 3}), "");
}

const LabelByHand moved{LabelSpot{{1.5, -2}, LabelSpot::Side::Left}};

TEST(ChangeLabel, OfAMark_IsKept_UntilItIsPutBack) {
  const Scene after = edited(distanceScene(), {ChangeLabel{"distance.F", moved}});
  EXPECT_EQ(after.labels, (LabelsByHand{{"distance.F", moved}}));
  EXPECT_EQ(after.entries, distanceScene().entries);
  EXPECT_NE(after, distanceScene());
  EXPECT_EQ(edited(after, {ChangeLabel{"distance.F", {}}}), distanceScene());
  EXPECT_EQ(edited(after, {ChangeLabel{"distance.F", LabelByHand()}}), distanceScene());
}

TEST(ChangeLabel, TooFarAwayOrOfNoNumber_IsBroughtWithinBounds) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const Scene after = edited(distanceScene(), {ChangeLabel{"Q", LabelByHand{LabelSpot{{1e9, none}}}},
                                               ChangeLabel{"E", LabelByHand{LabelSpot{{1.0 / 3, -1e9}}}}});
  EXPECT_EQ(after.labels.at("Q").spot->offset, glm::dvec2(mostLabelOffset, 0));
  EXPECT_EQ(after.labels.at("E").spot->offset, glm::dvec2(0.33, -mostLabelOffset));
}

TEST(ReplaceEntry, ByAnotherNameAndSort_IsFollowedByWhatLooksAtIt_AndByItsLabels) {
  Scene labelled = edited(chain(), {ChangeLabel{"Q", moved}});
  labelled = edited(labelled, {AddEntry{0, {"A", PointObject{{1, 2, 3}}}}});
  const Formula twice{FormulaKind::Product, {}, {}, {{FormulaKind::Number, 2}, {FormulaKind::Name, 0, "A"}}};
  const Entry derived{"P", DerivedObject{findKind("point"), {twice}}};
  const Scene after = edited(labelled, {ReplaceEntry{"Q", derived}});
  EXPECT_EQ(namesOf(after), (std::vector<std::string>{"A", "E", "P", "distance", "again"}));
  EXPECT_EQ(std::get<ConstructionUse>(after.entries.find("distance")->content).roles.at("Q"),
            RoleObjects("P"));
  EXPECT_EQ(after.labels, (LabelsByHand{{"P", moved}}));
  EXPECT_EQ(evaluate(after).find("P")->offers.front().given->object, Object(PointObject{{2, 4, 6}}));
}

TEST(ReplaceEntry, ByWhatOthersCannotLookAtOrByATakenName_IsRefused) {
  EXPECT_NE(refusal(chain(), ReplaceEntry{"Q", {"Q", PlaneObject{{0, 0, 0}, {0, 0, 1}}}}), "");
  EXPECT_NE(refusal(chain(), ReplaceEntry{"Q", {"E", PointObject{}}}), "");
  EXPECT_EQ(refusal(chain(), ReplaceEntry{"X", {"X", PointObject{}}}), "There is no “X” in the scene.");
}

TEST(AddEntry, WithANameThatIsWrittenLikeAnother_IsRefused) {
  Scene scene = chain();
  scene.entries.push_back({"P_1", PointObject{}});
  EXPECT_EQ(refusal(scene, AddEntry{0, {"P1", PointObject{}}}),
            "“P1” would be written like “P_1”, which is there already.");
  EXPECT_EQ(refusal(scene, RenameEntry{"P_1", "P1"}), "");
  EXPECT_EQ(refusal(scene, AddEntry{0, {"P2", PointObject{}}}), "");
}

TEST(ReplaceEntry, WithALookThatItCannotHave_IsRefusedWithASentence) {
  Entry distance = *chain().entries.find("distance");
  distance.color = Hue::Red;
  distance.line = LineStyle::Dotted;
  distance.isHidden = true;
  EXPECT_EQ(refusal(chain(), ReplaceEntry{"distance", distance}), "");
  Entry number{"k", NumberObject{1, 0, 2, 1}};
  number.isHidden = true;
  EXPECT_EQ(refusal(chain(), AddEntry{0, number}), "“k” is a number: it is in no picture.");
  number.color = Hue::Red;
  EXPECT_EQ(refusal(chain(), AddEntry{0, number}), "“k” has no colour of its own.");
}

TEST(ChangeLabel, OfNoEntryOrBeyondTheLimits_IsRefused) {
  EXPECT_EQ(refusal(distanceScene(), ChangeLabel{"X.n", moved}), "There is no “X” in the scene.");
  EXPECT_NE(refusal(distanceScene(), ChangeLabel{"", moved}), "");
  EXPECT_NE(refusal(distanceScene(), ChangeLabel{"Q." + std::string(longestMarkId, 'a'), moved}), "");
  Scene full = distanceScene();
  for (std::size_t i = 0; i < mostLabelsByHand; ++i)
    full.labels["Q." + std::to_string(i)] = moved;
  EXPECT_EQ(refusal(full, ChangeLabel{"Q", moved}), "At most 200 labels can be moved or hidden.");
  EXPECT_EQ(refusal(full, ChangeLabel{"Q.7", LabelByHand{{}, true}}), "");
}

TEST(ChangeLabel, FollowsANewName_AndGoesWithItsEntry) {
  const Scene labelled =
      edited(chain(), {ChangeLabel{"distance", moved}, ChangeLabel{"distance.F/angle", moved},
                       ChangeLabel{"E/side", moved}, ChangeLabel{"again.F", moved}});
  const Scene renamed = edited(labelled, {RenameEntry{"distance", "d"}});
  EXPECT_EQ(renamed.labels,
            (LabelsByHand{{"E/side", moved}, {"again.F", moved}, {"d", moved}, {"d.F/angle", moved}}));
  EXPECT_EQ(edited(renamed, {RemoveEntry{"d", true}}).labels, (LabelsByHand{{"E/side", moved}}));
}

TEST(Edits, ThousandsAtRandom_LeaveScenesThatCanBeEvaluatedWrittenAndRead) {
  int accepted = 0;
  std::array<int, std::variant_size_v<Edit>> byKind{};
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    RandomEdits random(seed);
    Scene scene = chain();
    Evaluation evaluation = evaluate(scene);
    for (int i = 0; i < 400; ++i) {
      const Edit edit = random.next(scene);
      const auto after = apply(scene, edit);
      if (!after) {
        EXPECT_FALSE(after.problem().sentence.empty());
        continue;
      }
      ++accepted;
      ++byKind.at(edit.index());
      ASSERT_FALSE(checkScene(*after));
      scene = *after;
      evaluation = evaluate(scene, evaluation);
      ASSERT_EQ(evaluation.entries.size(), scene.entries.size());
      const Session session{"x", 0, scene};
      ASSERT_TRUE(*readSession(writeSession(session), "x") == session) << writeSession(session);
    }
    // What was taken over from step to step is what evaluating anew gives.
    const Evaluation anew = evaluate(scene);
    for (std::size_t k = 0; k < anew.entries.size(); ++k)
      EXPECT_EQ(evaluation.entries[k].outcome->told->description, anew.entries[k].outcome->told->description);
    EXPECT_EQ(figureOf(evaluation).marks, figureOf(anew).marks);
  }
  EXPECT_GT(accepted, 2000);
  for (const int count : byKind)
    EXPECT_GT(count, 60) << "every sort of edit: " << testing::PrintToString(byKind);
}

} // namespace
} // namespace halfspace
