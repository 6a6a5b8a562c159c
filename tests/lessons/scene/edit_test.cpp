#include "lessons/scene/edit.h"

#include "lessons/object/coordinate_limits.h"
#include "lessons/scene/scene_checker.h"
#include "lessons/scene/session_file.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

#include <random>

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
            sentenceForTooLarge());
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

/// Makes edits at random, sensible ones and others.
class RandomEdits {
public:
  explicit RandomEdits(std::uint64_t seed) : m_engine(seed) {}

  Edit next(const Scene &scene) {
    switch (below(6)) {
    case 0:
      return anyChange(scene);
    case 1:
      return AddEntry{below(scene.entries.size() + 1), anyEntry(scene)};
    case 2:
      return RemoveEntry{anyName(scene), below(3) == 0};
    case 3:
      return RenameEntry{anyName(scene), newName()};
    case 4:
      return anyRebinding(scene);
    default:
      return MoveEntry{anyName(scene), below(scene.entries.size() + 1)};
    }
  }

private:
  std::size_t below(std::size_t end) { return m_engine() % end; }
  int small() { return static_cast<int>(below(19)) - 9; }
  ExactVec3 vector() {
    const int x = small();
    const int y = small();
    return {x, y, small()};
  }
  std::string newName() { return "N" + std::to_string(below(40)); }
  std::string anyName(const Scene &scene) {
    return scene.entries.empty() ? "none" : scene.entries[below(scene.entries.size())].name;
  }
  std::string anyReference(const Scene &scene) {
    const std::string name = anyName(scene);
    return below(2) == 0 ? name : name + "." + (below(2) == 0 ? "F" : "H");
  }
  /// Mostly of the kind that the object is of.
  Edit anyChange(const Scene &scene) {
    const std::string name = anyName(scene);
    const Object *object = findObject(scene, name);
    return ChangeObject{name, object && below(4) > 0 ? objectOf(kindOf(*object)) : anyObject()};
  }
  /// Of a role that there is, where there is one: to anything, or to what a construction looks at already.
  Edit anyRebinding(const Scene &scene) {
    std::vector<const Entry *> uses;
    for (const Entry &entry : scene.entries)
      if (std::holds_alternative<ConstructionUse>(entry.content))
        uses.push_back(&entry);
    if (uses.empty())
      return RebindRole{anyName(scene), "E", anyReference(scene)};
    const auto rolesOf = [](const Entry *entry) { return std::get<ConstructionUse>(entry->content).roles; };
    const Entry *use = uses[below(uses.size())];
    const auto roles = rolesOf(use);
    const std::string role = std::next(roles.begin(), static_cast<int>(below(roles.size())))->first;
    const auto others = rolesOf(uses[below(uses.size())]);
    const auto other = others.find(role);
    return RebindRole{use->name, role, other == others.end() ? anyReference(scene) : other->second};
  }
  Object anyObject() { return objectOf(objectKinds()[below(objectKinds().size())]); }
  Object objectOf(std::string_view kind) {
    Object object = *makeObject(kind);
    for (std::size_t i = 0; i < coordinatesOf(object).size(); ++i)
      for (int axis = 0; axis < numbersIn(coordinatesOf(object)[i].role); ++axis)
        coordinate(object, i)[axis] = small();
    object.kind().settle(object);
    return object;
  }
  Entry anyEntry(const Scene &scene) {
    std::string name = newName();
    if (below(2) == 0)
      return {std::move(name), anyObject()};
    const Construction &construction = constructions()[below(constructions().size())];
    ConstructionUse use{std::string(construction.id), {}};
    for (const ConstructionRole &role : construction.roles)
      use.roles[role.name] = anyReference(scene);
    return {std::move(name), std::move(use)};
  }

  std::mt19937_64 m_engine;
};

TEST(Edits, ThousandsAtRandom_LeaveScenesThatCanBeEvaluatedWrittenAndRead) {
  int accepted = 0;
  std::array<int, 6> byKind{};
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
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
