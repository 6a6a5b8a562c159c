// How the objects of a scene are written and placed, and what a handle among them can snap to.
#include "lessons/scene/scene_letters.h"

#include "lessons/scene/edit.h"
#include "lessons/scene/hand/snap_targets.h"
#include "lessons/scene/scene_checker.h"
#include "lessons/term/plain_text.h"
#include "tests/lessons/scene/random_edits.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace halfspace {
namespace {

using namespace test;

/// A point on the line g, so many of its directions from its start.
Entry pointOnLine(std::string name, const Rational &lambda, std::string host = "g") {
  Object object = *makeObject("point-on-line");
  object[0].x = lambda;
  return {std::move(name), std::move(object), std::move(host)};
}

std::vector<std::string> lettersIn(const Given<Object> &given) {
  std::vector<std::string> texts;
  for (const Symbol &symbol : given.letters)
    texts.push_back(plainText(symbol));
  return texts;
}

std::vector<std::string> lettersOf(const Scene &scene, const std::string &name) {
  return lettersIn(SceneLetters(scene).given(name, *findObject(scene, name)));
}

using Texts = std::vector<std::string>;

TEST(SceneLetters, OfACoordinateThatTwoObjectsHave_SayWhoseItIs) {
  Scene scene{{planeE(), pointQ()}};
  EXPECT_EQ(lettersOf(scene, "E"), (Texts{"P₀", "n"}));
  scene.entries.push_back({"G", PlaneObject{{0, 0, 0}, {0, 0, 1}}});
  EXPECT_NE(lettersOf(scene, "E"), lettersOf(scene, "G"));
  EXPECT_NE(lettersOf(scene, "E").at(1), "n");
  EXPECT_EQ(lettersOf(scene, "Q"), Texts{"Q"}) << "a point goes by its name alone";
}

TEST(SceneLetters, OfANameWithAnIndex_HaveIt_HoweverItIsTyped) {
  for (const char *name : {"P12", "P_12"})
    EXPECT_EQ(lettersOf({{{name, PointObject{}}}}, name), Texts{"P₁₂"});
  EXPECT_EQ(lettersOf({{{"P_a", PointObject{}}}}, "P_a"), Texts{"P_a"}) << "a word";
  const Scene planes{{{"E_1", PlaneObject{{0, 0, 0}, {0, 0, 1}}}, planeE()}};
  EXPECT_EQ(lettersOf(planes, "E_1").at(1), "n_E₁");
}

TEST(SceneLetters, OfAPointCalledLikeACoordinate_LeaveItTheLetter) {
  const Scene scene{{planeE(), {"n", PointObject{{1, 2, 3}}}}};
  EXPECT_EQ(lettersOf(scene, "n"), Texts{"n"});
  EXPECT_EQ(lettersOf(scene, "E").at(0), "P₀");
  EXPECT_NE(lettersOf(scene, "E").at(1), "n");
}

TEST(SceneLetters, OfWhatTwoConstructionsMake_SayWhoseItIs) {
  Scene scene = distanceScene();
  const Object foot = PointObject{{1, 2, 3}};
  EXPECT_EQ(lettersIn(SceneLetters(scene).made("distance", "F", foot)), Texts{"F"});
  scene.entries.push_back({"other", ConstructionUse{"signed-distance", {{"E", "E"}, {"Q", "distance.F"}}}});
  const SceneLetters letters(scene);
  const Given<Object> first = letters.made("distance", "F", foot);
  EXPECT_NE(lettersIn(first), lettersIn(letters.made("other", "F", foot)));
  EXPECT_EQ(first.id, "distance.F");
  EXPECT_EQ(first.symbol.owner, "distance");
  EXPECT_FALSE(first.isFree);
  EXPECT_EQ(letters.namingOf(scene.entries.back()).made.at("F").symbol.owner, "other");
}

TEST(SceneLetters, OfAConstructionsOwn_AreSharedOnlyWhereAnotherHasThem) {
  Scene scene = distanceScene();
  const auto shared = [&] { return SceneLetters(scene).namingOf(scene.entries[2]).shared; };
  EXPECT_TRUE(shared().empty());
  scene.entries.push_back({"w", PointObject{}});
  EXPECT_EQ(shared(), std::set<std::string>{"w"});
  scene.entries.push_back({"other", ConstructionUse{"signed-distance", {{"E", "E"}, {"Q", "w"}}}});
  EXPECT_GT(shared().size(), 1U) << "another of its kind has them all";
}

/// Every way in which something of the scene is written, one a letter.
Texts allLettersOf(const Scene &scene) {
  const SceneLetters letters(scene);
  Texts all;
  const auto append = [&](const Texts &texts) { all.insert(all.end(), texts.begin(), texts.end()); };
  for (const Entry &entry : scene.entries)
    if (const auto *object = std::get_if<Object>(&entry.content))
      append(lettersIn(isBound(entry) ? letters.freedoms(entry.name, *object)
                                      : letters.given(entry.name, *object)));
    else
      for (const ConstructionRole &made :
           findConstruction(std::get<ConstructionUse>(entry.content).id)->makes)
        append(lettersIn(letters.made(entry.name, made.name, *makeObject(made.kind))));
  return all;
}

TEST(SceneLetters, OfScenesAtRandom_TellEverythingApart) {
  const Texts names{"F", "n", "P0", "Q", "g", "r", "lambda", "w", "A"}; // as coordinates and feet are called
  RandomEdits random(41);
  Scene scene;
  std::size_t most = 0;
  for (std::size_t i = 0; i < 10000; ++i) {
    const Edit rename =
        RenameEntry{scene.entries.empty() ? "" : scene.entries.back().name, names[i / 3 % names.size()]};
    if (const auto next = halfspace::apply(scene, i % 3 == 0 ? rename : random.next(scene)))
      scene = *next;
    Texts all = allLettersOf(scene);
    most = std::max(most, all.size());
    std::sort(all.begin(), all.end());
    const auto twice = std::adjacent_find(all.begin(), all.end());
    ASSERT_EQ(twice, all.end()) << *twice;
  }
  EXPECT_GT(most, 10U);
}

TEST(PlacedScene, WithAHostThatIsNotThere_LeavesTheBoundPointOut) {
  Scene scene{{planeE(),
               {"F", PlaneObject{{0, 0, 0}, {0, 0, 1}}},
               {"meet", ConstructionUse{"plane-plane", {{"E", "E"}, {"F", "F"}}}},
               pointOnLine("P", 2, "meet.g"),
               {"g", LineObject{{0, 0, 0}, {1, 0, 0}}},
               pointOnLine("R", 3)}};
  EXPECT_EQ(PlacedScene(scene).bound.size(), 2U);
  setCoordinate(scene, {"F", 1}, {1, 2, 2});
  const PlacedScene parallel(scene);
  ASSERT_EQ(parallel.bound.size(), 1U) << "parallel planes meet in no line";
  EXPECT_EQ(parallel.bound.front().name, "R");
  EXPECT_EQ(parallel.bound.front().point->object[0], ExactVec3(3, 0, 0));
  EXPECT_FALSE(parallel.bound.front().point->isFree);
}

std::multiset<std::string> targetsOf(const Scene &scene, const std::string &id) {
  std::multiset<std::string> names;
  for (const SnapTarget &target : snapTargets(scene, handle(scene, id)))
    names.insert(target.name);
  return names;
}

using Names = std::multiset<std::string>;

TEST(SnapTargets, OfAPoint_AreThePlacesOfAllOtherObjects) {
  const Scene scene{{planeE(), pointQ(), triangleT(), {"R", PointObject{{1, 1, 1}}}}};
  const Names ofQ = targetsOf(scene, "Q");
  for (const char *name : {"plane E", "point R", "corner P₁", "corner P₂", "edge P₁P₂"})
    EXPECT_EQ(ofQ.count(name), 1U) << name;
  EXPECT_EQ(ofQ.count("point Q"), 0U) << "a point does not catch at itself";
  EXPECT_EQ(targetsOf(scene, "R").count("point Q"), 1U);
}

TEST(SnapTargets, OfAWholeObjectOrOneThatIsGone_AreNone) {
  const Scene scene{{triangleT(), pointQ()}};
  EXPECT_TRUE(snapTargets(scene, handle(scene, "T.whole")).empty());
  const Handle point = handle(scene, "Q");
  EXPECT_FALSE(snapTargets(scene, point).empty());
  EXPECT_TRUE(snapTargets(Scene{{triangleT()}}, point).empty());
}

TEST(SnapTargets, AmongBoundPoints_LeaveOutThoseThatMoveWithTheHandle) {
  const Scene scene{{{"g", LineObject{{0, 0, 0}, {1, 0, 0}}},
                     pointOnLine("P", 1),
                     pointOnLine("R", 2),
                     {"Q", PointObject{{5, 5, 0}}}}};
  EXPECT_EQ(targetsOf(scene, "g.A").count("point P"), 0U);
  EXPECT_EQ(targetsOf(scene, "P").count("point P"), 0U);
  EXPECT_EQ(targetsOf(scene, "P").count("point R"), 1U) << "it stays where it is";
  EXPECT_EQ(targetsOf(scene, "Q").count("point R"), 1U);
}

TEST(SceneChecker, OfANameThatWasMade_FindsItsOnlyMaker) {
  SceneChecker checker;
  EXPECT_EQ(checker.idOf("F"), "F");
  for (const Entry &entry : distanceScene().entries)
    EXPECT_FALSE(checker.check(entry));
  EXPECT_EQ(checker.idOf("F"), "distance.F");
  EXPECT_EQ(checker.idOf("Q"), "Q");
  SceneChecker withPoint = checker;
  EXPECT_FALSE(withPoint.check({"F", PointObject{}}));
  EXPECT_EQ(withPoint.idOf("F"), "F") << "an entry's own name goes first";
  EXPECT_FALSE(checker.check({"other", ConstructionUse{"signed-distance", {{"E", "E"}, {"Q", "Q"}}}}));
  EXPECT_EQ(checker.idOf("F"), "F") << "two make one";
}

class EntryNames : public testing::TestWithParam<std::pair<std::string, bool>> {};

TEST_P(EntryNames, OfLettersDigitsAndMarks_AreTakenAndOthersRefused) {
  const auto problem = checkScene({{{GetParam().first, PointObject{}}}});
  EXPECT_EQ(!problem, GetParam().second) << (problem ? problem->text() : "");
  EXPECT_TRUE(!problem || problem->field == "name");
}

INSTANTIATE_TEST_SUITE_P(Spelled, EntryNames,
                         testing::Values(std::pair("P", true), std::pair("a-b_2", true), std::pair("", false),
                                         std::pair("2P", false), std::pair("-P", false),
                                         std::pair("P.n", false), std::pair("P Q", false),
                                         std::pair("λ", false),
                                         std::pair(std::string(maxNameLength, 'x'), true),
                                         std::pair(std::string(maxNameLength + 1, 'x'), false)));

TEST(SceneChecker, OfVeryManyEntries_StopsAtTheLimit) {
  SceneChecker checker;
  for (std::size_t i = 0; i < maxSceneEntries; ++i)
    ASSERT_FALSE(checker.check({"P" + std::to_string(i), PointObject{}}));
  const auto problem = checker.check({"Q", PointObject{}});
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->sentence, tooManyEntries().sentence);
}

} // namespace
} // namespace halfspace
