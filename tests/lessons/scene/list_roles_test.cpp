// Roles that are a list of objects: as they are written, checked, evaluated and edited.
#include "lessons/scene/file/scene_writer.h"
#include "lessons/scene/file/session_file.h"
#include "lessons/scene/near_special_cases.h"
#include "lessons/scene/scene_checker.h"
#include "lessons/scene/scene_letters.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace halfspace {
namespace {

using namespace test;
using Ids = std::vector<std::string>;

Entry planeAt(const std::string &name, int height) { return {name, PlaneObject{{0, 0, height}, {0, 0, 1}}}; }

Entry way(RoleObjects planes) {
  return {"way", ConstructionUse{"ray-plane-substitution", {{"planes", std::move(planes)}, {"L", "L"}}}};
}

/// A ray straight up from the ground, and planes at the heights 1, 2 and 3 in another order.
Scene threePlanes() {
  return {{planeAt("E", 2),
           planeAt("F", 1),
           planeAt("G", 3),
           {"L", RayObject{{0, 0, 0}, {0, 0, 1}}},
           way(Ids{"E", "F", "G"})}};
}

const Ids &planesOf(const Scene &scene) {
  return std::get<ConstructionUse>(scene.entries.back().content).roles.at("planes").ids;
}

/// A session file around planes E and F, a ray L and a construction with these roles.
Result<Session> readWith(const std::string &roles) {
  return readSession(R"({"format":"halfspace","version":1,"lesson":"x","step":0,"scene":[
{"name":"E","plane":{"P0":[0,0,2],"n":[0,0,1]}},{"name":"F","plane":{"P0":[0,0,1],"n":[0,0,1]}},
{"name":"L","ray":{"Q":[0,0,0],"r":[0,0,1]}},
{"name":"way","construction":"ray-plane-substitution","of":)" +
                         roles + "}]}",
                     "my.halfspace");
}

Problem problemWith(const std::string &roles) {
  const auto session = readWith(roles);
  if (session) {
    ADD_FAILURE() << "was read: " << roles;
    return {};
  }
  return session.problem();
}

TEST(ListRole, Written_IsReadAgain) {
  const Session session{"x", 0, threePlanes()};
  const auto again = readSession(writeSession(session), "my.halfspace");
  ASSERT_TRUE(again) << again.problem().text();
  EXPECT_EQ(*again, session);
  EXPECT_EQ(rolesJson(std::get<ConstructionUse>(session.scene.entries.back().content)).dump(),
            R"({"L":"L","planes":["E","F","G"]})");
}

TEST(ListRole, OfOneObject_NeedsNoBrackets) {
  const auto bare = readWith(R"({"planes":"E","L":"L"})");
  const auto listed = readWith(R"({"planes":["E"],"L":"L"})");
  ASSERT_TRUE(bare && listed);
  EXPECT_EQ(*bare, *listed);
  EXPECT_EQ(planesOf(bare->scene), Ids{"E"});
}

TEST(ListRole, ThatCannotBe_IsRefusedWithItsPlace) {
  EXPECT_EQ(problemWith(R"({"L":"L"})").sentence,
            "This construction looks at a list planes: name a plane or several.");
  EXPECT_EQ(problemWith(R"({"planes":[],"L":"L"})").sentence,
            "Here a list of 1 to 8 objects is expected, as [E, F].");
  EXPECT_EQ(problemWith(R"({"planes":["E","E"],"L":"L"})").sentence,
            "“E” stands twice in this list: name it once.");
  EXPECT_EQ(problemWith(R"({"planes":["E","L"],"L":"L"})").sentence,
            "Here a plane is expected, but “L” is a ray.");
  EXPECT_EQ(problemWith(R"({"planes":["E",["F"]],"L":"L"})").field, "scene[3].of.planes[1]");
  EXPECT_EQ(problemWith(R"({"planes":["E","H"],"L":"L"})").field, "scene[3].of.planes");
  EXPECT_EQ(problemWith(R"({"planes":["E"],"L":["L","L"]})").sentence,
            "Here one object is expected, not a list of them.");
}

TEST(ListRole, OfMoreThanItsMost_IsRefused) {
  Scene scene{{{"L", RayObject{{0, 0, 0}, {0, 0, 1}}}}};
  Ids names;
  for (std::size_t i = 0; i <= maxListedObjects; ++i) {
    names.push_back("E" + std::to_string(i));
    scene.entries.push_back(planeAt(names.back(), static_cast<int>(i)));
  }
  scene.entries.push_back(way(names));
  EXPECT_TRUE(checkScene(scene));
  names.pop_back();
  scene.entries.replace(scene.entries.size() - 1, way(names));
  EXPECT_FALSE(checkScene(scene));
  EXPECT_EQ(evaluate(scene).find("way")->looksAt.size(), maxListedObjects + 1) << "all planes, and the ray";
}

TEST(ListRole, Evaluated_LooksAtItsObjectsInTheirOrder) {
  const Evaluation evaluation = evaluate(threePlanes());
  const EvaluatedEntry &way = *evaluation.find("way");
  Ids ids;
  for (const auto &given : way.looksAt)
    ids.push_back(given->id);
  EXPECT_EQ(ids, (Ids{"E", "F", "G", "L"}));
  EXPECT_EQ(way.outcome->told->description,
            "More than one plane has a t of 0 or more: the smallest of these tells which is hit first.");
}

TEST(ListRole, OfARenamedObject_FollowsIt) {
  const Scene after = edited(threePlanes(), {RenameEntry{"F", "ground"}});
  EXPECT_EQ(planesOf(after), (Ids{"E", "ground", "G"}));
  EXPECT_FALSE(checkScene(after));
}

TEST(ListRole, OfARemovedObject_GoesWithIt) {
  EXPECT_FALSE(apply(threePlanes(), RemoveEntry{"F"}));
  const Scene after = edited(threePlanes(), {RemoveEntry{"F", true}});
  EXPECT_EQ(after.entries.size(), 3U);
  EXPECT_EQ(dependentsOf(threePlanes(), "G"), Ids{"way"});
}

TEST(ListRole, Rebound_LooksAtTheNewList) {
  const Scene after = edited(threePlanes(), {RebindRole{"way", "planes", Ids{"G", "E"}}});
  EXPECT_EQ(planesOf(after), (Ids{"G", "E"}));
  EXPECT_EQ(evaluate(after).find("way")->looksAt.size(), 3U);
  EXPECT_FALSE(apply(threePlanes(), RebindRole{"way", "planes", Ids{}}));
  EXPECT_FALSE(apply(threePlanes(), RebindRole{"way", "planes", Ids{"G", "G"}}));
  EXPECT_FALSE(apply(threePlanes(), RebindRole{"way", "L", Ids{"L", "L"}})) << "no list";
}

TEST(ListRole, OfAMovedObject_KeepsItsOrder) {
  const Scene after = edited(threePlanes(), {MoveEntry{"G", 0}});
  EXPECT_EQ(planesOf(after), (Ids{"E", "F", "G"}));
  EXPECT_FALSE(apply(threePlanes(), MoveEntry{"G", 4})) << "below what looks at it";
}

TEST(ListRole, NearASpecialCase_ChangesTheObjectThatIsMeant) {
  Scene scene = threePlanes();
  setObject(scene, "E", PlaneObject{{0, 0, q(3, 2)}, {0, 0, 1}});
  const auto all = specialCasesNear(scene, evaluate(scene), {"way"});
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all.front().sentence, "The ray would hit F and E at one point.");
  EXPECT_EQ(all.front().change.value().name, "E");
  EXPECT_EQ(lastOutcome(evaluate(edited(scene, {all.front().change.value()}))).told->description,
            "E and F have the same t (t_E = 1): the ray hits them at one point.");
}

} // namespace
} // namespace halfspace
