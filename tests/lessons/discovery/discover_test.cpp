// What holds of objects, here or always.
#include "lessons/discovery/discover.h"
#include "lessons/discovery/facts.h"
#include "lessons/discovery/moved_scene.h"
#include "lessons/pseudo_language.h"
#include "lessons/scene/scene_checker.h"
#include "lessons/typed/typed_scene.h"
#include "tests/effort.h"
#include "tests/lessons/spoken_to_in.h"
#include "tests/untranslated.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace halfspace {
namespace {

using Ids = std::vector<std::string>;

std::vector<Discovery> discoveries(const std::string &scene, const Ids &selected) {
  const auto read = readTypedScene(scene, "");
  if (!read) {
    ADD_FAILURE() << read.problem().text();
    return {};
  }
  return discoveriesOf(evaluate(*read), selected);
}

/// The sentences, with “always” or “here” before them.
Ids told(const std::string &scene, const Ids &selected) {
  Ids sentences;
  for (const Discovery &each : discoveries(scene, selected))
    sentences.push_back((each.isAlways ? "always: " : "here: ") + each.sentence);
  return sentences;
}

bool has(const Ids &sentences, const std::string &sentence) {
  return std::find(sentences.begin(), sentences.end(), sentence) != sentences.end();
}

constexpr const char *corners = "A = (1, 2, 3)\nB = (5, 0, 1)\nC = (-2, 4, 6)\nD = (0, 7, -3)\n";

TEST(Discoveries, OfTheMidpointsOfTwoSides_AreParallelToTheThird) {
  const std::string scene = std::string(corners) + "M = (A + B)/2\nN = (A + C)/2\n";
  EXPECT_EQ(told(scene, {"M", "N", "B", "C"}),
            (Ids{"always: M, N, B and C lie in one plane.", "always: The lines MN and BC are parallel."}));
}

TEST(Discoveries, OfTheMidpointsOfFourSidesInSpace_AreAParallelogram) {
  const Ids sentences =
      told(std::string(corners) + "P = (A + B)/2\nQ = (B + C)/2\nR = (C + D)/2\nS = (D + A)/2\n",
           {"P", "Q", "R", "S"});
  EXPECT_TRUE(has(sentences, "always: P, Q, R and S lie in one plane."));
  EXPECT_TRUE(has(sentences, "always: The lines PQ and RS are parallel."));
  EXPECT_TRUE(has(sentences, "always: The lines PS and QR are parallel."));
  EXPECT_TRUE(has(sentences, "always: P is as far from Q as R is from S."));
}

TEST(Discoveries, OfTheMedians_MeetInOnePoint) {
  const std::string medians = std::string(corners) + "L = (B + C)/2\nM = (A + C)/2\nN = (A + B)/2\n"
                                                     "a = line(A, L)\nb = line(B, M)\nc = line(C, N)\n"
                                                     "S = (A + B + C)/3\n";
  EXPECT_TRUE(has(told(medians, {"a", "b", "c"}), "always: a, b and c meet in one point."));
  EXPECT_EQ(told(medians, {"S", "b"}), Ids{"always: S lies on the line b."});
}

TEST(Discoveries, OfPointsOnARayAndInATriangle_HoldBeyondTheirEnds) {
  const std::string onRay =
      "r = (1, 2, 3) + t(2, -1, 4)\nP = point-on-ray(r, 2)\nM = (r.Q + P)/2\nA = r.Q + (0, 0, 0)\n";
  EXPECT_TRUE(has(told(onRay, {"A", "M", "P"}), "always: M is the midpoint of A and P."));
  const std::string inside = std::string(corners) +
                             "T = triangle(A, B, C)\nP = point-on-triangle(T, 1/4, 1/4)\n"
                             "N = (A + P)/2\n";
  EXPECT_TRUE(has(told(inside, {"A", "N", "P"}), "always: N is the midpoint of A and P."));
}

TEST(Discoveries, OfTheFootOfAPoint_HoldWhereverThatIs) {
  const std::string scene = "Q = (11, 15, 8)\nE: x + 2y + 2z = 27\nd = distance(Q, E)\n";
  EXPECT_EQ(told(scene, {"d.F", "E"}), Ids{"always: F lies in the plane E."});
  EXPECT_EQ(told(scene, {"Q", "d.F", "E"}),
            (Ids{"always: F lies in the plane E.", "always: Q is as far from F as from E.",
                 "always: The line QF is perpendicular to E."}));
}

TEST(Discoveries, OfAPointOfASphere_SeeTheDiameterAtARightAngle) {
  const std::string scene = "M = (1, 2, 3)\nS = sphere(M, 5)\nA = point-on-sphere(S, 1, 2)\nB = 2M - A\n"
                            "P = point-on-sphere(S, 1/3, -2)\n";
  EXPECT_EQ(told(scene, {"P", "A", "B"}), Ids{"always: At P there is a right angle between A and B."});
  EXPECT_TRUE(has(told(scene, {"M", "A", "P"}), "always: M is as far from A as from P."));
}

TEST(Discoveries, OfFreeObjects_HoldHereOnly) {
  EXPECT_EQ(told("A = (1, 1, 1)\nB = (2, 2, 2)\nC = (4, 4, 4)\n", {"A", "B", "C"}),
            Ids{"here: A, B and C lie on one line."});
  EXPECT_EQ(told("E: x + y = 1\nF: z = 3\n", {"E", "F"}), Ids{"here: E and F are perpendicular."});
  EXPECT_EQ(told("A = (1, 1, 1)\nB = (2, 2, 2)\nC = (4, 4, 5)\n", {"A", "B", "C"}), Ids());
}

TEST(Discoveries, OfFreeObjectsAtRoundPlaces_AreNeverAlways) {
  std::mt19937 random(7);
  const auto triple = [&] {
    std::string text = "(";
    for (int axis = 0; axis < 3; ++axis)
      text += (axis > 0 ? ", " : "") + std::to_string(random() % 3);
    return text + ")";
  };
  int here = 0;
  for (int i = 0; i < test::effort(100); ++i) {
    const std::string scene = "A = " + triple() + "\nB = " + triple() + "\nC = " + triple() +
                              "\nD = " + triple() + "\nu = " + triple() + "\nE = plane(" + triple() + ", " +
                              triple() + ")\ng = line(" + triple() + ", " + triple() + ")\n";
    for (const Ids &selected : {Ids{"A", "B", "C", "D"}, Ids{"A", "B", "g", "E"}, Ids{"u", "g", "E", "A"}})
      for (const Discovery &each : discoveries(scene, selected)) {
        EXPECT_FALSE(each.isAlways) << scene << each.sentence;
        ++here;
      }
  }
  EXPECT_GT(here, test::atLeast(300));
}

TEST(Discoveries, OfSumsOfPoints_AreAlwaysWhereTheFormulaSaysSo) {
  for (int a = -2; a <= 2; ++a)
    for (int b = -2; b <= 2; ++b)
      for (int c = -2; c <= 2; ++c) {
        // All at the height 0: here the four are in one plane whatever the sum is.
        const std::string scene = "A = (3, 1, 0)\nB = (-2, 5, 0)\nC = (1, -4, 0)\nP = " + std::to_string(a) +
                                  "A + " + std::to_string(b) + "B + " + std::to_string(c) + "C\n";
        const Ids sentences = told(scene, {"A", "B", "C", "P"});
        const std::string inOnePlane = "A, B, C and P lie in one plane.";
        EXPECT_EQ(has(sentences, "always: " + inOnePlane), a + b + c == 1) << scene;
        EXPECT_EQ(has(sentences, "here: " + inOnePlane), a + b + c != 1) << scene;
        const bool isOnSide = c == 0 && a + b == 1 && a != 0 && b != 0;
        EXPECT_EQ(has(sentences, "always: A, B and P lie on one line."), isOnSide) << scene;
      }
}

TEST(Discoveries, OfWhatIsAlmostTrue_AreNone) {
  EXPECT_EQ(told("A = (0, 0, 0)\nB = (1, 1, 1)\nC = (1000001, 1000001, 1000000)\n", {"A", "B", "C"}), Ids());
  EXPECT_EQ(told("u = (1000000, 1, 0)\nv = (1000000, 1.000001, 0)\n", {"u", "v"}), Ids());
}

TEST(Discoveries, WhereTheObjectsAreSeldomThere_HoldHere) {
  // The radius is negative, so that there is no sphere, unless B stays almost where it is.
  const std::string scene = "A = (1, 2, 3)\nB = (1, 0, 0)\nS = sphere(A, 1 - 100(B.x - 1)^2 - 100(B.y)^2)\n"
                            "P = point-on-sphere(S, 1, 2)\n";
  EXPECT_EQ(told(scene, {"P", "S"}), Ids{"here: P lies on the sphere S."});
  EXPECT_EQ(told(scene + "C = 1A\n", {"P", "A", "C"}), Ids{"always: A and C are the same point."});
}

TEST(Discoveries, OfNumbersThatFollow_AreIdentities) {
  const std::string scene = "k = 3/2, 0 <= k <= 5, step 1/2\nm = (k + 1)^2 - k^2 - 2k\nn = 2k - 2\n";
  EXPECT_EQ(told(scene + "e = 1, 1 <= e <= 1, step 0\n", {"m", "e"}),
            Ids{"always: m and e are the same number."});
  EXPECT_EQ(told(scene, {"m", "n"}), Ids{"here: m and n are the same number."});
}

TEST(Discoveries, OfWhatIsNotThere_AreNone) {
  EXPECT_EQ(told(corners, {}), Ids());
  EXPECT_EQ(told(corners, {"nobody", "A"}), Ids());
  EXPECT_EQ(told("A = (1, 2, 3)\nv = (0, 0, 0)\ng = line(A, v)\n", {"A", "g"}), Ids());
  EXPECT_EQ(told("A = (1, 2, 3)\nB = (1, 2, 3)\n", {"A", "A", "B"}),
            Ids{"here: A and B are the same point."});
}

TEST(Discoveries, Told_SayHowFarTheyHold) {
  const auto found = discoveries("A = (1, 2, 3)\nB = (1, 2, 3)\nC = 1A\n", {"A", "B", "C"});
  ASSERT_GE(found.size(), 2U);
  EXPECT_EQ(wordsFor(found.front()), "A and C are the same point. This holds wherever the free objects are.");
  EXPECT_EQ(found.front().ids, (Ids{"A", "C"}));
  EXPECT_EQ(wordsFor(found.back()),
            "B and C are the same point. This holds here, but need not hold elsewhere.");
}

/// A scene in which a fact holds, and the objects that it holds of.
struct Holding {
  const char *scene;
  Ids selected;
  const char *sentence;
};

const std::vector<Holding> holdings{
    {"A = (1, 2, 3)\nB = 1A", {"A", "B"}, "always: A and B are the same point."},
    {"A = (1, 2, 3)\ng = line(A, (1, 1, 1))", {"g", "A"}, "always: A lies on the line g."},
    {"A = (1, 2, 3)\nB = (0, 1, 1)\ns = segment(A, B)\nP = 3A - 2B",
     {"P", "s"},
     "always: P lies on the line along s."},
    {"A = (1, 2, 3)\nE = plane(A, (1, 1, 1))", {"A", "E"}, "always: A lies in the plane E."},
    {"A = (1, 2, 3)\nB = (0, 1, 1)\nT = triangle(A, B, (4, 5, 0))\nM = (A + B)/2",
     {"M", "T"},
     "always: M lies in the plane of T."},
    {"S = sphere((1, 2, 3), 4)\nP = point-on-sphere(S, 1, 2)", {"P", "S"}, "always: P lies on the sphere S."},
    {"M = (1, 2, 3)\nS = sphere(M, 4)", {"M", "S"}, "always: M is the centre of the sphere S."},
    {"A = (1, 2, 3)\nB = (0, 1, 1)\nC = (4, 0, 0)\nE = plane(A, B, C)\ng = line(A, B)",
     {"g", "E"},
     "always: g lies in the plane E."},
    {"A = (1, 2, 3)\nB = (0, 1, 1)\nT = triangle(A, B, (4, 5, 0))\nr = ray(A, B)",
     {"T", "r"},
     "always: r lies in the plane of T."},
    {"A = (1, 2, 3)\nB = (0, 1, 1)\ng = line(A, B)\ns = segment(B, A)",
     {"g", "s"},
     "always: g and s lie on one line."},
    {"A = (1, 2, 3)\nB = (0, 1, 1)\nC = (4, 0, 0)\nE = plane(A, B, C)\nT = triangle(C, B, A)",
     {"E", "T"},
     "always: E and T lie in one plane."},
    {"A = (1, 2, 3)\ng = line(A, (1, 0, 1))\nh = line(A, (1, 1, 1))",
     {"g", "h"},
     "always: g and h meet in one point."},
    {"v = (1, 2, 3)\ng = line((0, 0, 1), v)\nE = plane((4, 4, 4), v × (1, 0, 0))",
     {"g", "E"},
     "always: g and E are parallel."},
    {"v = (1, 2, 3)\nE = plane((4, 4, 4), v)", {"v", "E"}, "always: v and E are perpendicular."},
    {"A = (1, 2, 3)\nv = (1, 5, 1)\ns = segment(A, A + v)", {"v", "s"}, "always: v and s are equally long."},
    {"S = sphere((0, 0, 0), 3)\nE = plane((1, 2, 2), (1, 2, 2))",
     {"E", "S"},
     "here: E touches the sphere S."},
    {"S = sphere((0, 0, 0), 3)\nU = sphere((5, 0, 0), 2)",
     {"S", "U"},
     "here: The spheres S and U touch each other."},
    {"M = (1, 2, 3)\nS = sphere(M, 4)\nU = sphere(M, 2)",
     {"S", "U"},
     "always: The spheres S and U have the same centre."},
    {"S = sphere((0, 0, 0), 3)\nU = sphere((5, 0, 0), S.R)",
     {"S", "U"},
     "always: The spheres S and U have the same radius."},
    {"k = 2\nm = k + k\nn = 2k", {"m", "n"}, "always: m and n are the same number."},
    {"A = (1, 2, 3)\ng = line(A, (1, 0, 1))\nh = line(A, (1, 1, 1))\ni = line(A, (0, 0, 1))",
     {"g", "h", "i"},
     "always: g, h and i meet in one point."},
    {"A = (1, 2, 3)\nB = (0, 1, 1)\nP = 3A - 2B", {"A", "B", "P"}, "always: A, B and P lie on one line."},
    {"A = (1, 2, 3)\nB = (0, 1, 1)\nM = (A + B)/2", {"A", "B", "M"}, "always: M is the midpoint of A and B."},
    {"A = (1, 2, 3)\nB = (0, 1, 1)\nC = A + (A - B) × (1, 2, 5)",
     {"A", "B", "C"},
     "always: At A there is a right angle between B and C."},
    {"E: x = 1\nF: y = 1\nP = (4, 4, 9)", {"E", "F", "P"}, "here: P is as far from E as from F."},
    {"E: x = 1\nA = (4, 4, 9)\nB = A + (1, 2, 3) × E.n",
     {"A", "B", "E"},
     "always: A and B are equally far from E."},
    {"A = (1, 2, 3)\nv = (1, 5, 1)\nB = A + 3v", {"A", "B", "v"}, "always: The line AB is parallel to v."},
    {"A = (1, 2, 3)\nE: x + y = 2\nB = A + 3E.n",
     {"A", "B", "E"},
     "always: The line AB is perpendicular to E."},
    {"A = (1, 2, 3)\nB = (0, 1, 1)\nC = (4, 0, 0)\nD = A + B - C",
     {"A", "B", "C", "D"},
     "always: A, B, C and D lie in one plane."},
    {"A = (1, 2, 3)\nB = (0, 1, 1)\nC = (4, 0, 0)\nD = C + 2(B - A)",
     {"A", "B", "C", "D"},
     "always: The lines AB and CD are parallel."},
    {"A = (1, 2, 3)\nB = (0, 1, 1)\nC = (4, 0, 0)\nD = C + (B - A) × (1, 2, 5)",
     {"A", "B", "C", "D"},
     "always: The lines AB and CD are perpendicular."},
    {"A = (1, 2, 3)\nB = (0, 1, 1)\nC = (4, 0, 0)\nD = C + (B - A)",
     {"A", "B", "C", "D"},
     "always: A is as far from B as C is from D."},
};

TEST(Discoveries, OfObjectsOfWhichAFactHolds_TellIt) {
  for (const Holding &each : holdings)
    EXPECT_TRUE(has(told(each.scene, each.selected), each.sentence))
        << each.scene << "\n"
        << each.sentence << "\n"
        << testing::PrintToString(told(each.scene, each.selected));
}

TEST(Discoveries, ToldInAnotherLanguage_HaveNoWordOfThis) {
  const test::SpokenToIn nobody(pseudoLanguage());
  for (const Holding &each : holdings)
    for (const Discovery &discovery : discoveries(each.scene, each.selected))
      EXPECT_EQ(test::untranslatedIn(wordsFor(discovery)), std::vector<std::string>());
}

TEST(Facts, EachOfThem_IsHeldByTheTest) {
  EXPECT_EQ(holdings.size(), facts().size());
  for (std::size_t i = 0; i < facts().size(); ++i) {
    std::string_view rest = facts()[i].sentence.english;
    const std::string told = holdings[i].sentence;
    while (!rest.empty()) { // piece by piece, between its names
      const std::size_t open = std::min(rest.find('{'), rest.size());
      EXPECT_NE(told.find(rest.substr(0, open)), std::string::npos) << told << facts()[i].sentence.english;
      rest.remove_prefix(std::min(rest.find('}', open), rest.size() - 1) + 1);
    }
  }
}

TEST(SceneMover, MovesWhatIsFree_AndNothingElse) {
  const Scene scene =
      *readTypedScene("A = (1, 2, 3)\nk = 2, 0 <= k <= 5, step 1\nM = k A\nE: x = 1\n"
                      "W = polygon((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0))\n"
                      "P = point-on-plane(E, (1, 2, 3))\nd = distance(P, E)\nS = sphere(A, k)\n"
                      "U = sphere((1, 1, 1), 1)\n",
                      "");
  SceneMover mover(1);
  for (int i = 0; i < 20; ++i) {
    const Scene moved = i % 2 == 0 ? mover.movedNearby(scene) : mover.movedFar(scene);
    const auto problem = checkScene(moved);
    EXPECT_FALSE(problem) << problem->sentence;
    for (const char *name : {"M", "d", "S"})
      EXPECT_EQ(*moved.entries.find(name), *scene.entries.find(name));
    for (const char *name : {"A", "E", "W", "U", "P"})
      EXPECT_FALSE(*moved.entries.find(name) == *scene.entries.find(name)) << name;
  }
}

TEST(SceneMover, TakesWhatObjectsFollow_AndNothingElse) {
  const Scene scene = *readTypedScene("A = (1, 2, 3)\nB = (1, 2, 4)\nE: x = 1\nF: y = 1\nd = distance(A, E)\n"
                                      "M = (d.F + A)/2\nN = F.n\ng = line(B, N)\n",
                                      "");
  const auto namesOf = [](const Scene &some) {
    Ids names;
    for (const Entry &entry : some.entries)
      names.push_back(entry.name);
    return names;
  };
  EXPECT_EQ(namesOf(sceneBehind(scene, {"M"})), (Ids{"A", "E", "d", "M"}));
  EXPECT_EQ(namesOf(sceneBehind(scene, {"d.F", "N"})), (Ids{"A", "E", "F", "d", "N"}));
  EXPECT_EQ(namesOf(sceneBehind(scene, {})), Ids());
}

} // namespace
} // namespace halfspace
