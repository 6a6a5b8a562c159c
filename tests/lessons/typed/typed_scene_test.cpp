#include "lessons/typed/typed_scene.h"

#include "lessons/scene/scene_checker.h"
#include "lessons/typed/write_line.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

std::vector<std::string> linesOf(const Result<Scene> &scene) {
  std::vector<std::string> lines;
  if (scene)
    for (const Entry &entry : scene->entries)
      lines.push_back(lineFor(entry));
  else
    lines.push_back(scene.problem().sentence);
  return lines;
}

TEST(TypedScene, OfCoordinatesAlone_IsPointsUnderFreeNames) {
  const std::vector<std::string> points{"A = (1, 2, 3)", "B = (-4, 1/2, 6)"};
  EXPECT_EQ(linesOf(readTypedScene("1, 2, 3\n-4, 1/2, 6\n", "")), points);
  EXPECT_EQ(linesOf(readTypedScene("1\t2\t3\r\n-4\t0.5\t6", "")), points);
  EXPECT_EQ(linesOf(readTypedScene("(1; 2; 3)\n\n-4 1/2 6  # the second", "")), points);
  EXPECT_EQ(linesOf(readTypedScene("1; 2; 3\n-4; 0,5; 6", "", ',')), points);
}

TEST(TypedScene, BelowOthers_GoesOnWithThem_AndTakesNoNameTwice) {
  const auto above = readTypedScene("A = (0, 0, 1)\nC = (9, 9, 9)", "");
  EXPECT_EQ(linesOf(readTypedScene("1, 2, 3\nM = (A + B)/2", "", '.', *above)),
            (std::vector<std::string>{"A = (0, 0, 1)", "C = (9, 9, 9)", "B = (1, 2, 3)", "M = (A + B)/2"}));
}

TEST(TypedScene, WithTwoNumbersOrWords_IsNoPoint) {
  EXPECT_FALSE(readTypedScene("1, 2", ""));
  EXPECT_FALSE(readTypedScene("1, 2, x", ""));
  EXPECT_FALSE(readTypedScene("1, 2, 3, 4", ""));
}

TEST(TypedScene, OfMoreLinesThanASceneHasEntries_SaysSoAtOnce) {
  std::string text;
  for (int i = 0; i < 100000; ++i)
    text += "1, 2, 3\n";
  const auto read = readTypedScene(text, "points.csv");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.problem().sentence, tooManyEntries().sentence);
  EXPECT_EQ(read.problem().line, static_cast<int>(maxSceneEntries) + 1);
}

} // namespace
} // namespace halfspace
