#include "lessons/scene/scene_looks.h"

#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/vector.h"
#include "lessons/scene/edit.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace halfspace {
namespace {

using namespace test;

Entry plane(const std::string &name, std::optional<Hue> color = {}) {
  return {name, PlaneObject{{1, 2, 3}, {1, 2, 2}}, "", color};
}

std::set<std::string> idsOfHue(const Evaluation &evaluation, Hue hue) {
  std::set<std::string> ids;
  for (const Mark &mark : figureOf(evaluation).marks)
    if (hueOf(baseOf(mark)) == hue)
      ids.insert(baseOf(mark).id);
  return ids;
}

TEST(SceneLooks, OfTheFirstAboutASubject_AreThoseOfItsMarksSubjects) {
  for (const Look &look : looksOf({{planeE(), pointQ(), rayL(), triangleT()}}))
    EXPECT_EQ(look, Look());
}

TEST(SceneLooks, OfManyPlanes_AreNeverTwiceTheSame) {
  Scene scene{{rayL(), pointQ()}};
  for (int i = 0; i < 20; ++i)
    scene.entries.push_back(plane("E" + std::to_string(i)));
  std::set<std::pair<Hue, std::size_t>> seen;
  const std::vector<Look> looks = looksOf(scene);
  for (std::size_t i = 2; i < looks.size(); ++i)
    EXPECT_TRUE(seen.emplace(looks[i].hue.value_or(hueOf(Subject::Plane)), looks[i].rank).second) << i;
}

TEST(SceneLooks, OfAFurtherPlane_HaveAHueThatNothingElseHas) {
  const std::vector<Look> looks =
      looksOf({{plane("E"), plane("F"), rayL(), pointQ(), {"T", triangleT().content}, plane("G")}});
  for (const std::size_t further : {1U, 5U})
    for (const Subject taken : {Subject::Plane, Subject::Ray, Subject::Point, Subject::Triangle})
      EXPECT_NE(looks[further].hue, hueOf(taken));
  EXPECT_NE(looks[1].hue, looks[5].hue);
}

TEST(SceneLooks, OfAnEntryWithAColor_HaveIt_AndOthersKeepOffIt) {
  const std::vector<Look> looks = looksOf({{plane("E", Hue::Pink), plane("F"), plane("G", Hue::Green)}});
  EXPECT_EQ(looks[0].hue, Hue::Pink);
  EXPECT_EQ(looks[2].hue, Hue::Green);
  ASSERT_TRUE(looks[1].hue);
  EXPECT_NE(looks[1].hue, Hue::Pink);
  EXPECT_NE(looks[1].hue, Hue::Green);
}

TEST(SceneLooks, OfWhatIsNotDrawn_CountForNothing) {
  const Entry number{"k", NumberObject{}};
  const std::vector<Look> looks = looksOf({{number, {"m", number.content}, planeE()}});
  EXPECT_EQ(looks, std::vector<Look>(3));
}

TEST(SceneLooks, AreThoseOfAllMarksOfTheObject) {
  const Scene scene{{plane("E"), plane("F", Hue::Purple)}};
  EXPECT_EQ(idsOfHue(evaluate(scene), Hue::Purple), (std::set<std::string>{"F", "F.n", "F.P0"}));
}

TEST(SceneLooks, AreThoseOfWhatSpeaksOfOneObjectAlone) {
  Scene scene{{plane("E"), {"F", PlaneObject{{2, 6, 0}, {0, 1, 1}}, "", Hue::Purple}}};
  scene.entries.push_back({"meeting", ConstructionUse{"plane-plane", {{"E", "E"}, {"F", "F"}}}});
  EXPECT_TRUE(idsOfHue(evaluate(scene), Hue::Purple).contains("meeting.phi/second"));
  EXPECT_FALSE(idsOfHue(evaluate(scene), Hue::Purple).contains("meeting.phi/first"));
}

TEST(SceneLooks, ChangeWithTheColorOfAnEntry_ThoughNothingElseDoes) {
  Scene scene{{plane("E"), plane("F")}};
  const Evaluation before = evaluate(scene);
  scene.entries.change(1, [](Entry &entry) { entry.color = Hue::Red; });
  EXPECT_TRUE(idsOfHue(evaluate(scene, before), Hue::Red).contains("F.n"));
}

TEST(SceneLooks, OfAnEntry_AreKeptByEditsOfIt) {
  const Scene scene{{plane("E"), plane("F", Hue::Red)}};
  const auto moved = apply(scene, ChangeObject{"F", PlaneObject{{0, 0, 1}, {0, 0, 1}}});
  ASSERT_TRUE(moved);
  EXPECT_EQ(moved->entries[1].color, Hue::Red);
  const auto renamed = apply(scene, RenameEntry{"F", "G"});
  ASSERT_TRUE(renamed);
  EXPECT_EQ(renamed->entries[1].color, Hue::Red);
}

TEST(Hues, HaveANameEach_ByWhichTheyAreFound) {
  const std::vector<std::string> names = hueNames();
  ASSERT_EQ(std::set<std::string>(names.begin(), names.end()).size(), hueCount);
  for (const std::string &name : names)
    EXPECT_EQ(nameOf(findHue(name).value()), name);
  EXPECT_FALSE(findHue("mauve"));
}

/// The colours in which the objects of a scene are drawn, by name.
std::map<std::string, Hue> huesIn(const Scene &scene) {
  std::map<std::string, Hue> hues;
  const std::vector<Look> looks = looksOf(scene);
  for (std::size_t i = 0; i < looks.size(); ++i)
    hues[scene.entries[i].name] = looks[i].hue.value_or(hueOf(*kindOf(scene.entries[i])->subject));
  return hues;
}

TEST(KeepingColors, LeavesTheObjectsThatWereThere_TheirColors) {
  const Scene before{{plane("E"), plane("F"), plane("G"), plane("H", Hue::Red)}};
  for (const Edit &edit :
       {Edit(RemoveEntry{"E"}), Edit(AddEntry{4, {"T", triangleT().content}}), Edit(MoveEntry{"G", 0})}) {
    Scene after = before;
    for (const Edit &each : keepingColors(before, {edit}))
      after = *apply(after, each);
    const auto hues = huesIn(after);
    for (const auto &[name, hue] : huesIn(before))
      if (hues.contains(name)) {
        EXPECT_EQ(hues.at(name), hue) << name;
      }
  }
}

TEST(KeepingColors, OfVeryManyObjects_SaysNone) {
  Scene scene;
  for (int i = 0; i < 300; ++i)
    scene.entries.push_back(plane("E" + std::to_string(i)));
  EXPECT_EQ(keepingColors(scene, {RemoveEntry{"E0"}}).size(), 1U);
}

TEST(KeepingColors, OfAnEntryThatIsReplaced_LeavesItsLookToWhoReplacesIt) {
  const Scene scene{{plane("E"), plane("F", Hue::Red), plane("G")}};
  for (const Edit &edit : keepingColors(scene, {ReplaceEntry{"F", plane("F")}}))
    if (const auto *replaced = std::get_if<ReplaceEntry>(&edit); replaced && replaced->name == "F") {
      EXPECT_EQ(replaced->entry.color, std::nullopt);
    }
}

TEST(KeepingColors, WhereNothingElseChanges_SaysNone) {
  EXPECT_EQ(keepingColors({{plane("E"), plane("F")}}, {RemoveEntry{"F"}}).size(), 1U);
}

} // namespace
} // namespace halfspace
