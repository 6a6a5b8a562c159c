// Scenes that are typed, an entry a line.
#include "tests/app/command_fixture.h"

namespace halfspace {
namespace {

using Typed = Program;

const std::string distance = "E: x + 2y + 2z = 27\nQ = (11, 15, 8)\n\nd = distance(Q, E) # how far?\n";

TEST_F(Typed, Scene_IsExplained_AsThatOfALesson) {
  write("scene.txt", distance);
  const Ran ran = run("explain --typed scene.txt");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("f(Q) = 30 is positive"), std::string::npos) << ran.out;
  const auto json = explained("--typed scene.txt");
  EXPECT_EQ(json.at("case"), "positive");
  EXPECT_EQ(json.at("scene").size(), 3U);
}

TEST_F(Typed, Scene_ComesFromStandardInputToo_WithValuesOfThisCall) {
  write("scene.txt", distance);
  const Ran ran = runWith(">.out 2>.err <scene.txt", "explain --typed - --format json --set Q=0,0,0");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(nlohmann::json::parse(ran.out).at("case"), "negative");
}

TEST_F(Typed, SceneOfFormulas_TellsWhatTheyComeTo) {
  write("scene.txt", "A = (1, 2, 3)\nB = (4, 0, 0)\nM = (A + B)/2\n");
  EXPECT_EQ(run("explain --typed scene.txt").out, "M = (5/2, 1, 3/2)\n");
}

TEST_F(Typed, LineThatIsWrong_IsToldWithItsPlace_AndWhatWasPerhapsMeant) {
  write("scene.txt", "Q = (1, 2, 3)\nE: z = 0\nd = distence(Q, E)\n");
  const Ran ran = run("explain --typed scene.txt");
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(ran.err, "halfspace: scene.txt:3: Column 5: There is no “distence”. Perhaps you meant: d = "
                     "distance(Q, E)\n");
}

TEST_F(Typed, Scene_ThatCannotBeRead_IsRefused) {
  write("scene.txt", distance);
  expectRefused("explain signed-distance --typed scene.txt", "--typed");
  expectRefused("explain --typed nowhere.txt", "nowhere.txt");
  write("bytes.txt", std::string("Q = \x01\xff", 6));
  expectRefused("explain --typed bytes.txt", "bytes.txt");
}

} // namespace
} // namespace halfspace
