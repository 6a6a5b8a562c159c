#include "lessons/lesson/entry_names.h"

#include "lessons/lesson/condition.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halfspace {
namespace {

/// The value that is offered by a name; nothing where there is none.
std::optional<ValueName> offered(const Scene &scene, const std::string &name) {
  for (const OfferedValue &each : comparableValues(scene))
    if (each.name == name)
      return each.value;
  return {};
}

TEST(ComparableValues, OfOneConstruction_GoByTheirOwnNames) {
  const Scene scene = test::distanceScene();
  ASSERT_TRUE(offered(scene, "side"));
  EXPECT_EQ(offered(scene, "side")->words, (std::vector<std::string>{"positive", "negative", "on"}));
  EXPECT_TRUE(offered(scene, "case") && offered(scene, "foot.x") && offered(scene, "signed_distance"));
  EXPECT_FALSE(offered(scene, "foot")) << "a list is not compared";
}

TEST(ComparableValues, OfSeveralConstructions_SayWhoseTheyAre) {
  Scene scene = test::distanceScene();
  scene.entries.push_back({"again", ConstructionUse{"signed-distance", {{"E", "E"}, {"Q", "distance.F"}}}});
  EXPECT_FALSE(offered(scene, "side"));
  EXPECT_TRUE(offered(scene, "distance.side") && offered(scene, "again.foot.z"));
  const auto cases = offered(scene, "again.case");
  ASSERT_TRUE(cases);
  EXPECT_NE(std::find(cases->words.begin(), cases->words.end(), "missing-object"), cases->words.end());
}

TEST(ComparableValues, AreFoundByTheirNames) {
  Scene scene = test::distanceScene();
  scene.entries.push_back({"again", ConstructionUse{"signed-distance", {{"E", "E"}, {"Q", "distance.F"}}}});
  const Evaluation evaluation = evaluate(scene);
  int found = 0;
  for (const OfferedValue &each : comparableValues(scene))
    found += findValue(evaluation, each.name) ? 1 : 0;
  EXPECT_GT(found, 10);
}

} // namespace
} // namespace halfspace
