#include "lessons/typed/entry_summary.h"

#include "lessons/typed/typed_scene.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

/// What the last line of a scene is, and comes to.
std::pair<std::string, std::string> summaryOfLast(const std::string &lines) {
  const auto scene = readTypedScene(lines, "");
  if (!scene)
    return {scene.problem().sentence, ""};
  const EntrySummary summary = summaryOf(scene->entries[scene->entries.size() - 1], evaluate(*scene));
  return {summary.definition, summary.value};
}

using Told = std::pair<std::string, std::string>;

TEST(EntrySummary, OfWhatTellsItself_HasNoValueBesides) {
  EXPECT_EQ(summaryOfLast("Q = (1, 2, 3)"), Told("(1, 2, 3)", ""));
  EXPECT_EQ(summaryOfLast("E: x + 2y = 3"), Told("x + 2y = 3", ""));
  EXPECT_EQ(summaryOfLast("E: x + 2y = 3, green, dashed, locked"), Told("x + 2y = 3, locked", ""));
}

TEST(EntrySummary, OfAPlaneByAPointAndOfWhatFollowsOthers_IsWhatTheyComeTo) {
  EXPECT_EQ(summaryOfLast("E = plane((5, 0, 0), (1, 2, 2))"),
            Told("plane((5, 0, 0), (1, 2, 2))", "x + 2y + 2z − 5 = 0"));
  EXPECT_EQ(summaryOfLast("A = (1, 2, 3)\nM = A/2"), Told("A/2", "(1/2, 1, 3/2)"));
}

TEST(EntrySummary, OfWhatGoesThroughPoints_NamesThem_WithoutTheirNumbers) {
  const std::string points = "A = (1, 2, 3)\nB = (7, 1, 0)\nC = (2, 6, 1)\n";
  EXPECT_EQ(summaryOfLast(points + "E = plane(A, B, C)"), Told("plane(A, B, C)", "14x + 9y + 25z − 107 = 0"));
  EXPECT_EQ(summaryOfLast(points + "T = triangle(A, B, C)"), Told("triangle(A, B, C)", ""));
  EXPECT_EQ(summaryOfLast(points + "T = triangle(A, B, 2C)"), Told("triangle(A, B, 2C)", "P₂ = (4, 12, 2)"));
}

TEST(EntrySummary, OfAConstruction_IsTheValueThatItIsNamedAfter) {
  const std::string objects = "E: x + 2y + 2z = 27\nQ = (11, 15, 8)\n";
  EXPECT_EQ(summaryOfLast(objects + "d = distance(E, Q)"), Told("signed-distance(E, Q)", "dist = 10"));
}

TEST(EntrySummary, OfAConstructionThatHasNoSuchValue_IsTheLastThatItLeadsTo) {
  EXPECT_EQ(summaryOfLast("T = triangle((0, 0, 0), (2, 0, 0), (0, 3, 0))\na = area(T)").second, "A = 3");
}

TEST(EntrySummary, OfAnAngle_IsInDegrees) {
  EXPECT_EQ(summaryOfLast("E: x = 1\nF: y = 1\na = angle(E, F)").second, "φ = 90°");
  EXPECT_EQ(summaryOfLast("E: x = 1\nF: x + 5y = 1\na = angle(E, F)").second, "φ ≈ 78.69°");
  EXPECT_EQ(summaryOfLast("g = (0, 0, 0) + t(1, 0, 1)\nE: z = 1\na = angle(g, E)").second, "α = 45°");
}

TEST(EntrySummary, OfAConstructionThatMakesObjects_IsItsCaseInWords) {
  EXPECT_EQ(
      summaryOfLast("E: x = 1\nF: x = 2\ng = intersect(E, F)").second,
      "The normals are multiples of each other, and no point lies in both planes: E and F are parallel.");
}

TEST(EntrySummary, OfANumber_IsItsValue) {
  EXPECT_EQ(summaryOfLast("k = 3/2, 0 <= k <= 5, step 1/2"), Told("3/2, 0 <= k <= 5, step 1/2", "3/2"));
}

TEST(EntrySummary, OfWhatIsNotThere_SaysSo) {
  EXPECT_EQ(summaryOfLast("k = 0\nP = (1/k, 0, 0)").second, "not there now");
  EXPECT_EQ(summaryOfLast("k = 0\nP = (1/k, 0, 0)\nE: z = 1\nd = distance(E, P)").second, "not there now");
}

TEST(EntrySummary, OfWhatIsNoneOfItsKind_SaysWhy) {
  const std::string points = "A = (1, 1, 1)\nB = (2, 2, 2)\nC = (3, 3, 3)\n";
  EXPECT_EQ(
      summaryOfLast(points + "E = plane(A, B, C)").second,
      "The normal of E is zero, so E is no plane. Through three points of one line there are many planes.");
  EXPECT_EQ(summaryOfLast(points + "g = line(A, A)").second, "The direction of g is zero: g leads nowhere.");
  EXPECT_EQ(summaryOfLast(points + "s = segment(A, A)").second, "Both ends of s are the same point.");
  EXPECT_EQ(summaryOfLast(points + "T = triangle(A, B, C)").second, "All corners of T lie on one line.");
}

} // namespace
} // namespace halfspace
