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
  EXPECT_EQ(found.line.substr(found.added), found.added > 0 ? line : found.line);
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
  for (const char *line : {"P = (1, 2, 3)", "E1: x = 3", " k=3", "Q = ", "d = distnce(A, B)"})
    EXPECT_EQ(named(line), line);
}

TEST(LineWithName, ThatCannotBeRead_LetsTheRestBeToldOf) {
  const auto read = readTypedScene("angle(A, F)", "", '.', scene());
  ASSERT_FALSE(read);
  EXPECT_TRUE(read.problem().sentence.starts_with("Column 7:")) << read.problem().sentence;
}

} // namespace
} // namespace halfspace
