// Objects whose coordinates follow others.
#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/sphere.h"
#include "lessons/object/kinds/vector.h"
#include "lessons/scene/file/session_file.h"
#include "lessons/typed/read_line.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halfspace {
namespace {

Scene typed(const std::vector<std::string> &lines) {
  Scene scene;
  for (const std::string &line : lines)
    scene.entries.push_back(std::get<Entry>(readLine(line, scene)));
  return scene;
}

/// Two points with their middle, its distance from a plane, and what follows that.
Scene middleScene() {
  return typed({"A = (1, 2, 3)", "B = (5, 0, 1)", "M = (A + B)/2, pink", "E: z = 0", "d = distance(M, E)",
                "v = d.F - A", "S = sphere(M, 3)"});
}

Object objectOf(const Evaluation &evaluation, const char *name) {
  return evaluation.find(name)->offers.front().given->object;
}

std::string problemIn(const std::string &entry) {
  const auto session =
      readSession(R"({"format":"halfspace","version":6,"lesson":"l","step":1,"scene":[)"
                  R"({"name":"A","point":[1,2,3]},{"name":"E","plane":{"P0":[0,0,0],"n":[0,0,1]}},)" +
                      entry + "]}",
                  "a.halfspace");
  return session ? "" : session.problem().text();
}

TEST(DerivedObjects, FollowWhatTheyAreMadeOf) {
  const Scene scene = middleScene();
  const Evaluation before = evaluate(scene);
  EXPECT_EQ(objectOf(before, "M"), Object(PointObject{{3, 1, 2}}));
  EXPECT_EQ(objectOf(before, "v"), Object(VectorObject{ExactVec3(0), {2, -1, -3}}));
  const auto moved = apply(scene, ChangeObject{"B", PointObject{{-1, 0, 1}}});
  ASSERT_TRUE(moved);
  const Evaluation after = evaluate(*moved, before);
  EXPECT_EQ(objectOf(after, "M"), Object(PointObject{{0, 1, 2}}));
  EXPECT_EQ(objectOf(after, "v"), Object(VectorObject{ExactVec3(0), {-1, -1, -3}}));
  EXPECT_EQ(objectOf(after, "S")[0], ExactVec3(0, 1, 2));
}

TEST(DerivedObjects, PlaneThroughPoints_IsDrawnAsFarAsThem) {
  const Figure figure =
      figureOf(evaluate(typed({"A = (0, 0, 0)", "B = (20, 0, 0)", "C = (0, -20, 0)", "E = plane(A, B, C)"})));
  const auto &patch = std::get<PlanePatchMark>(*findMark(figure, "E"));
  for (const Place &corner : {Place(20, 0, 0), Place(0, -20, 0)})
    EXPECT_NE(std::find(patch.covers.begin(), patch.covers.end(), corner), patch.covers.end());
}

TEST(DerivedObjects, PlaneThroughPoints_FollowsThem_WhereItStaysTheSamePlane) {
  const Scene scene = typed({"A = (0, 0, 0)", "B = (20, 0, 0)", "C = (0, -20, 0)", "E = plane(A, B, C)"});
  const Evaluation before = evaluate(scene);
  const auto moved = apply(scene, ChangeObject{"C", PointObject{{7, -20, 0}}});
  const Figure figure = figureOf(evaluate(*moved, before));
  const auto &covers = std::get<PlanePatchMark>(*findMark(figure, "E")).covers;
  EXPECT_NE(std::find(covers.begin(), covers.end(), Place(7, -20, 0)), covers.end());
  EXPECT_EQ(std::find(covers.begin(), covers.end(), Place(0, -20, 0)), covers.end());
}

TEST(DerivedObjects, ThatNothingConcerns_AreTheSameAsBefore) {
  const Scene scene = middleScene();
  const Evaluation before = evaluate(scene);
  const auto moved = apply(scene, ChangeObject{"E", PlaneObject{{0, 0, 1}, {0, 0, 1}}});
  const Evaluation after = evaluate(*moved, before);
  EXPECT_EQ(after.find("M")->outcome, before.find("M")->outcome);
  EXPECT_NE(after.find("v")->outcome, before.find("v")->outcome);
}

TEST(DerivedObjects, AreWrittenAndReadAgain) {
  const Session session{"l", 0, middleScene()};
  const auto again = readSession(writeSession(session), "a.halfspace");
  ASSERT_TRUE(again) << again.problem().text();
  EXPECT_EQ(*again, session);
}

TEST(DerivedObjects, OfNamesWithHyphens_AreReadAgain) {
  const Session session{"l", 0,
                        typed({"cut-2 = (1, 2, 3)", "M = 2 cut-2 - cut-2", "E: z = 0", "d-1 = distance(M, E)",
                               "N = d-1.F - cut-2"})};
  const auto again = readSession(writeSession(session), "a.halfspace");
  ASSERT_TRUE(again) << again.problem().text();
  EXPECT_EQ(*again, session);
}

TEST(DerivedObjects, AreDrawn_AndCannotBeTaken) {
  const Evaluation evaluation = evaluate(middleScene());
  const auto marks = figureOf(evaluation).marks;
  EXPECT_TRUE(
      std::any_of(marks.begin(), marks.end(), [](const Mark &mark) { return baseOf(mark).id == "M"; }));
  for (const Handle &handle : handlesOf(middleScene()))
    EXPECT_TRUE(handle.object == "A" || handle.object == "B" || handle.object == "E") << handle.id;
}

TEST(DerivedObjects, KnowOthersByTheirNewNames) {
  const auto renamed = apply(middleScene(), RenameEntry{"d", "distance"});
  ASSERT_TRUE(renamed) << renamed.problem().text();
  EXPECT_EQ(objectOf(evaluate(*renamed), "v"), Object(VectorObject{ExactVec3(0), {2, -1, -3}}));
  const auto again = apply(*renamed, RenameEntry{"A", "P"});
  ASSERT_TRUE(again) << again.problem().text();
  EXPECT_EQ(objectOf(evaluate(*again), "M"), Object(PointObject{{3, 1, 2}}));
}

TEST(DerivedObjects, GoWithWhatTheyAreMadeOf) {
  const Scene scene = middleScene();
  EXPECT_EQ(dependentsOf(scene, "B"), (std::vector<std::string>{"M", "d", "v", "S"}));
  EXPECT_FALSE(apply(scene, RemoveEntry{"B"}));
  EXPECT_FALSE(apply(scene, MoveEntry{"M", 0}));
  EXPECT_FALSE(apply(scene, ChangeObject{"M", PointObject{}}));
  const auto without = apply(scene, RemoveEntry{"B", true});
  ASSERT_TRUE(without);
  EXPECT_EQ(without->entries.size(), 2U);
}

TEST(DerivedObjects, OfAFile_AreRefusedWithASentence) {
  EXPECT_EQ(problemIn(R"({"name":"M","point":"2 A"})"), "");
  EXPECT_EQ(problemIn(R"({"name":"S","sphere":{"c":"A","R":"A.z"}})"), "");
  EXPECT_EQ(problemIn(R"({"name":"S","sphere":{"c":[1,2,3],"R":"A.z"}})"), "");
  for (const auto &[entry, part] :
       {std::pair(R"({"name":"M","point":"2 B"})", "no object “B”"),
        {R"({"name":"M","point":"2 +"})", "character 4"},
        {R"({"name":"M","point":"A + 1"})", "cannot be added"},
        {R"({"name":"M","point":"A.x"})", "three numbers"},
        {R"({"name":"M","point":"E"})", "“E” is a plane"},
        {R"({"name":"M","point":"M"})", "no object “M”"},
        {R"({"name":"S","sphere":{"c":"A","R":"A"}})", "a number is expected"},
        {R"({"name":"m","number":{"value":"A.x","from":0,"to":5,"step":1}})", "cannot follow others so"},
        {R"({"name":"S","sphere":{"c":"A"}})", "R"},
        {R"({"name":"S","sphere":{"c":"A","R":1,"x":2}})", "no such coordinate"}})
    EXPECT_NE(problemIn(entry).find(part), std::string::npos) << entry << ": " << problemIn(entry);
}

TEST(DerivedObjects, ThatCannotBe_SayWhy_AndComeBack) {
  const Scene scene = typed({"k = 1", "A = (k, 0, 0)", "S = sphere(A, k)", "P = A/(k - 2)"});
  const auto with = [&](const Rational &value) {
    return evaluate(*apply(scene, ChangeObject{"k", NumberObject{value, -10, 10, test::q(1, 10)}}));
  };
  EXPECT_EQ(with(-1).find("S")->outcome->told->name, "missing-object");
  EXPECT_NE(with(-1).find("S")->missing.find("cannot be"), std::string::npos) << with(-1).find("S")->missing;
  EXPECT_EQ(with(2).find("P")->missing, "P is not there now. This would be divided by zero.");
  EXPECT_EQ(with(3).find("P")->missing, "");
  EXPECT_EQ(objectOf(with(3), "S"), Object(SphereObject{{3, 0, 0}, 3}));
}

} // namespace
} // namespace halfspace
