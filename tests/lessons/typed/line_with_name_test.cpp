#include "lessons/typed/line_with_name.h"

#include "lessons/typed/typed_scene.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

const Scene &scene() {
  static const Scene scene =
      *readTypedScene("A = (1, 2, 3)\nB = (4, 5, 6)\nC = (0, 1, 0)\nE: z = 1\nF: x = 1\n", "");
  return scene;
}

std::string named(const std::string &line) {
  const LineWithName found = withName(line, scene());
  if (found.added > 0) {
    EXPECT_EQ(found.line.substr(found.added), line);
  }
  return found.line;
}

TEST(LineWithName, OfWhatHasNoName_HasTheUsualOneThatIsFree) {
  EXPECT_EQ(named("triangle(A, B, C)"), "T = triangle(A, B, C)");
  EXPECT_EQ(named("angle(E, F)"), "a = angle(E, F)");
  EXPECT_EQ(named("distance(A, B)"), "d = distance(A, B)");
  EXPECT_EQ(named("A + t(1, 2, 3)"), "g = A + t(1, 2, 3)");
  EXPECT_EQ(named("3/2"), "k = 3/2");
  EXPECT_EQ(named("(A + B)/2"), "D = (A + B)/2");
  EXPECT_EQ(named("x + 2y = 3"), "G: x + 2y = 3");
  EXPECT_EQ(named("x = 3"), "G: x = 3");
  EXPECT_EQ(named("2x = 3"), "G: 2x = 3");
  EXPECT_EQ(named("x-y = 1"), "G: x-y = 1");
  EXPECT_EQ(named("B - A"), "u = B - A");
  EXPECT_EQ(named("2(B - A)"), "u = 2(B - A)");
  EXPECT_EQ(named("shortest(B - A)"), "u = shortest(B - A)");
}

TEST(LineWithName, IsOfTheKindThatTheLineSays_WhateverLettersAreTaken) {
  const Scene full =
      *readTypedScene("A = (1, 2, 3)\nB = (4, 5, 6)\nC = (0, 1, 0)\nD = (1, 1, 1)\nP = (2, 0, 0)\n"
                      "Q = (3, 0, 0)\n",
                      "");
  EXPECT_EQ(withName("A + t(1, 2, 3)", full).line, "g = A + t(1, 2, 3)");
}

TEST(LineWithName, OfSignsInOddPlaces_ComesToAnEnd) {
  for (const char *line :
       {"|v|(1, 2, 3)", "|B - A|*(2)", "|()", "a|b(1)", "|", "(|||)", "", "=", ": 3", "= 3"})
    EXPECT_NE(withName(line, scene()).line.find(line), std::string::npos) << line;
}

TEST(LineWithName, OfAnEntryThatHasOne_IsThatOne_UnlessTheLineSaysAnother) {
  EXPECT_EQ(withName("midpoint(A, C)", std::string("M")).line, "M = midpoint(A, C)");
  EXPECT_EQ(withName("N = midpoint(A, C)", std::string("M")).line, "N = midpoint(A, C)");
  EXPECT_EQ(withName("x + y = 3", std::string("E")).line, "E: x + y = 3");
}

TEST(LineWithName, OfThreeNumbers_IsAPoint_HoweverTheyAreParted) {
  EXPECT_EQ(named("1, 2, 3"), "D = (1, 2, 3)");
  EXPECT_EQ(named("(1/2, -2, 3)"), "D = (1/2, -2, 3)");
  EXPECT_EQ(named("0,5; 1; 2"), "D = (0.5, 1, 2)");
  EXPECT_EQ(named("1\t2\t3"), "D = (1, 2, 3)");
  EXPECT_EQ(named("P(1|2|3)"), "P = (1, 2, 3)");
  EXPECT_EQ(named("(1 | -1/2 | 3)"), "D = (1, -1/2, 3)");
}

TEST(LineWithName, OfALineWithAName_IsThatLine) {
  for (const char *line :
       {"my-plane: x = 1", "A-1 = (1, 2, 3)", "x = (1, 2, 3)", "x = 3, -10 <= x <= 10, step 1/10",
        "P = (1, 2, 3)", "E1: x = 3", " k=3", "Q = ", "d = distnce(A, B)"})
    EXPECT_EQ(named(line), line);
}

TEST(LineWithName, ThatCannotBeRead_LetsTheRestBeToldOf) {
  const auto read = readTypedScene("angle(A, F)", "", '.', scene());
  ASSERT_FALSE(read);
  EXPECT_TRUE(read.problem().sentence.starts_with("Column 7:")) << read.problem().sentence;
}

} // namespace
} // namespace halfspace
