#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

TEST(SceneNames, ACoordinateThatOnlyOneObjectHas_GoesByItsShortName) {
  const Scene scene = distanceScene();
  EXPECT_EQ(shortName(scene, {"E", 1}), "n");
  EXPECT_EQ(fullName(scene, {"E", 1}), "E.n");
  EXPECT_EQ(shortName(scene, {"Q", 0}), "Q");
  EXPECT_EQ(fullName(scene, {"Q", 0}), "Q");
}

TEST(SceneNames, ACoordinateThatTwoObjectsHave_NeedsItsFullName) {
  const Scene scene{{planeE(), {"E2", PlaneObject{{0, 0, 0}, {0, 0, 1}}}}};
  EXPECT_EQ(shortName(scene, {"E2", 1}), "E2.n");
  EXPECT_FALSE(findCoordinate(scene, "n"));
  EXPECT_EQ(findCoordinate(scene, "E2.n"), (CoordinateId{"E2", 1}));
}

TEST(SceneNames, APointCalledLikeARaysStart_KeepsItsNameAndTheRayNeedsItsFullOne) {
  const Scene scene{{rayL(), pointQ()}};
  EXPECT_EQ(findCoordinate(scene, "Q"), (CoordinateId{"Q", 0}));
  EXPECT_EQ(shortName(scene, {"L", 0}), "L.Q");
}

TEST(SceneLookup, OfAConstructionOrAnUnknownName_FindsNoObject) {
  const Scene scene = distanceScene();
  EXPECT_EQ(findObject(scene, "distance"), nullptr);
  EXPECT_EQ(findObject(scene, "X"), nullptr);
  EXPECT_NE(findObject(scene, "E"), nullptr);
}

TEST(SceneLookup, OfTheCoordinatesOfOneEntry_ListsThoseOfAnObject) {
  EXPECT_EQ(coordinatesOf(distanceScene(), "E"), (std::vector<CoordinateId>{{"E", 0}, {"E", 1}}));
  EXPECT_TRUE(coordinatesOf(distanceScene(), "distance").empty());
  EXPECT_TRUE(coordinatesOf(distanceScene(), "X").empty());
}

TEST(SceneEdits, LeaveTheEntriesThatTheyDoNotTouchShared) {
  const Scene before = distanceScene();
  const auto touchedBy = [&](const Edit &edit) {
    std::vector<std::string> names;
    for (const Entry &entry : edited(before, {edit}).entries)
      if (before.entries.find(entry.name) != &entry)
        names.push_back(entry.name);
    return names;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(touchedBy(ChangeObject{"Q", PointObject{{1, 2, 3}}}), Names{"Q"});
  EXPECT_EQ(touchedBy(AddEntry{0, {"S", PointObject{}}}), Names{"S"});
  EXPECT_EQ(touchedBy(RemoveEntry{"distance"}), Names{});
  EXPECT_EQ(touchedBy(RenameEntry{"Q", "S"}), (Names{"S", "distance"}));
  EXPECT_EQ(touchedBy(MoveEntry{"Q", 0}), Names{"Q"});
}

TEST(SceneLookup, OfAllCoordinates_ListsThemFromTopToBottom) {
  const std::vector<CoordinateId> expected{{"E", 0}, {"E", 1}, {"Q", 0}};
  EXPECT_EQ(coordinatesOf(distanceScene()), expected);
}

} // namespace
} // namespace halfspace
