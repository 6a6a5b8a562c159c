// A learner's own mesh, put into a scene that has constructions which look at meshes.
#include "lessons/scene/target_mesh.h"

#include "lessons/object/kinds/mesh.h"
#include "lessons/object/kinds/number.h"
#include "lessons/scene/scene_checker.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;
using Ids = std::vector<std::string>;

/// One triangle, a right angle with two legs of this length.
std::shared_ptr<const MeshShape> cornerOf(double length) {
  const std::vector<Vec3<double>> corners{{0, 0, 0}, {length, 0, 0}, {0, length, 0}};
  return std::make_shared<const MeshShape>(corners, std::vector<MeshFace>{{0, 1, 2}});
}

Entry nearest(const std::string &name, const Ids &meshes) {
  return {name, ConstructionUse{"nearest-hit", {{"L", "L"}, {"i", "i"}, {"meshes", meshes}}}};
}

/// A ray, so many meshes, and the nearest hit among them.
Scene sceneWith(std::size_t meshes) {
  Scene scene{{{"L", RayObject{{0, 0, 9}, {0, 0, -1}}}, {"i", NumberObject{0, 0, 999, 1}}}};
  Ids names;
  for (std::size_t i = 0; i < meshes; ++i) {
    names.push_back("m" + std::to_string(i));
    scene.entries.push_back({names.back(), MeshObject{{}, {1, 0, 0}, 1, cornerOf(4)}});
  }
  scene.entries.push_back(nearest("hit", names));
  return scene;
}

Scene withAll(Scene scene, const std::vector<Edit> &edits) {
  for (const Edit &edit : edits) {
    auto after = apply(scene, edit);
    if (!after) {
      ADD_FAILURE() << after.problem().text();
      return scene;
    }
    scene = *after;
  }
  return scene;
}

Scene withTarget(const Scene &scene, std::shared_ptr<const MeshShape> shape) {
  return withAll(scene, editsForTarget(scene, std::move(shape)));
}

MeshObject targetIn(const Scene &scene) {
  return objectAs<MeshObject>(*findObject(scene, targetName)).value();
}

Ids meshesOf(const Scene &scene, const std::string &use) {
  for (const Entry &entry : scene.entries)
    if (entry.name == use)
      return std::get<ConstructionUse>(entry.content).roles.at("meshes").ids;
  return {};
}

TEST(TargetMesh, StandsBeforeTheConstructions_AndAllThatLookAtMeshesSeeIt) {
  Scene scene = sceneWith(2);
  scene.entries.push_back(nearest("again", {"m1"}));
  const auto shape = cornerOf(4);
  const Scene after = withTarget(scene, shape);
  EXPECT_FALSE(checkScene(after));
  EXPECT_EQ(targetIn(after).shape, shape) << "shared, not copied";
  EXPECT_EQ(meshesOf(after, "hit"), (Ids{"m0", "m1", targetName}));
  EXPECT_EQ(meshesOf(after, "again"), (Ids{"m1", targetName}));
}

TEST(TargetMesh, OfAnySize_IsScaledByARoundNumberToThatOfABarn) {
  for (const double length : {1e-8, 0.003, 0.7, 1.0, 8.0, 56.0, 40'000.0, 3e8}) {
    const Rational scale = targetIn(withTarget(sceneWith(1), cornerOf(length))).scale;
    EXPECT_GE(toDouble(scale) * length, 4) << length;
    EXPECT_LE(toDouble(scale) * length, 16) << length;
    Rational leading = scale;
    while (leading >= 10)
      leading = leading / 10;
    while (leading < 1)
      leading = leading * 10;
    EXPECT_TRUE(leading == 1 || leading == 2 || leading == 5) << toText(scale);
  }
}

TEST(TargetMesh, Another_StandsWhereTheFirstStood_WithAScaleOfItsOwn) {
  Scene scene = withTarget(sceneWith(1), cornerOf(4));
  MeshObject moved = targetIn(scene);
  moved.place = {3, 1, 2};
  moved.heading = {0, 2, 0};
  scene = edited(scene, {ChangeObject{targetName, moved}});
  const Scene after = withTarget(scene, cornerOf(400));
  EXPECT_EQ(targetIn(after).place, moved.place);
  EXPECT_EQ(targetIn(after).heading, moved.heading);
  EXPECT_EQ(targetIn(after).scale * 100, moved.scale);
  EXPECT_EQ(meshesOf(after, "hit"), (Ids{"m0", targetName})) << "once";
}

TEST(TargetMesh, WhereAListIsFull_IsThereAndNotLookedAt) {
  const Scene after = withTarget(sceneWith(maxListedObjects), cornerOf(4));
  EXPECT_FALSE(checkScene(after));
  EXPECT_TRUE(findObject(after, targetName));
  EXPECT_EQ(meshesOf(after, "hit").size(), maxListedObjects);
}

TEST(CopyOfMesh, StandsBesideIt_SharesItsShape_AndIsLookedAtWhereTheOtherIs) {
  Scene scene = sceneWith(2);
  scene.entries.push_back(nearest("again", {"m0"}));
  const auto copy = copyOfMesh(scene, "m1");
  ASSERT_TRUE(copy);
  EXPECT_EQ(copy->name, "m1B");
  const Scene with = withAll(scene, copy->edits);
  EXPECT_FALSE(checkScene(with));
  const MeshObject original = *objectAs<MeshObject>(*findObject(with, "m1"));
  const MeshObject made = *objectAs<MeshObject>(*findObject(with, "m1B"));
  EXPECT_EQ(made.shape, original.shape) << "shared, not copied";
  EXPECT_EQ(made.place, ExactVec3(0, 7, 0)) << "its width of 4, and a gap";
  EXPECT_EQ(meshesOf(with, "hit"), (Ids{"m0", "m1", "m1B"}));
  EXPECT_EQ(meshesOf(with, "again"), (Ids{"m0"})) << "which does not look at the other";
}

TEST(CopyOfMesh, OfATurnedAndScaledOne_StandsBesideItsWidth) {
  Scene scene = sceneWith(1);
  scene = edited(scene, {ChangeObject{"m0", MeshObject{{1, 2, 3}, {1, -5, 0}, q(3, 2), cornerOf(4)}}});
  const Scene with = withAll(scene, copyOfMesh(scene, "m0")->edits);
  EXPECT_EQ((*findObject(with, "m0B"))[0], ExactVec3(1 - 9, 2, 3));
}

TEST(CopyOfMesh, OfACopy_HasTheNextLetter) {
  Scene scene = sceneWith(1);
  scene = withAll(scene, copyOfMesh(scene, "m0")->edits);
  scene = withAll(scene, copyOfMesh(scene, "m0")->edits);
  scene = withAll(scene, copyOfMesh(scene, "m0C")->edits);
  EXPECT_EQ(meshesOf(scene, "hit"), (Ids{"m0", "m0B", "m0C", "m0D"}));
}

TEST(CopyOfMesh, WhereAListIsFull_OrNothingLooksAtIt_OrThereIsNone_IsNone) {
  EXPECT_FALSE(copyOfMesh(sceneWith(maxListedObjects), "m0"));
  EXPECT_FALSE(copyOfMesh(sceneWith(1), "L"));
  EXPECT_FALSE(copyOfMesh(sceneWith(1), "m7"));
  Scene scene = sceneWith(2);
  scene.entries.replace(scene.entries.size() - 1, nearest("hit", {"m0"}));
  EXPECT_FALSE(copyOfMesh(scene, "m1"));
}

TEST(RemoveMesh, OfACopy_LeavesTheSceneAsItWas) {
  Scene scene = sceneWith(2);
  scene.entries.push_back(nearest("again", {"m0", "m1"}));
  const auto copy = copyOfMesh(scene, "m1");
  const Scene with = withAll(scene, copy->edits);
  EXPECT_EQ(withAll(with, editsToRemoveMesh(with, copy->name)), scene);
}

TEST(MeshOfASceneOfOnesOwn, IsThereForNobodyYet_AndEachHasANameOfItsOwn) {
  const auto shape = cornerOf(4);
  const Scene one = withAll({}, editsForMesh({}, shape));
  const Scene two = withAll(one, editsForMesh(one, shape));
  ASSERT_EQ(two.entries.size(), 2U);
  for (const Entry &entry : two.entries)
    EXPECT_EQ(objectAs<MeshObject>(std::get<Object>(entry.content))->shape, shape);
}

TEST(RemoveMesh, TheOnlyOne_IsRefused) {
  const Scene scene = sceneWith(1);
  const Edit first = editsToRemoveMesh(scene, "m0").front();
  EXPECT_FALSE(apply(scene, first));
}

TEST(TargetMesh, IsTakenOnlyWhereAConstructionLooksAtMeshes) {
  Scene scene = sceneWith(1);
  EXPECT_TRUE(takesMeshes(scene));
  scene.entries.pop_back();
  EXPECT_FALSE(takesMeshes(scene));
}

} // namespace
} // namespace halfspace
