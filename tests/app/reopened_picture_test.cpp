// Pictures that are opened again from the command line.
#include "tests/app/command_fixture.h"

namespace halfspace {
namespace {

class ReopenedPicture : public Program {
protected:
  [[nodiscard]] std::string file(const std::string &name) const { return contentOf(inFolder(name)); }
};

TEST_F(ReopenedPicture, IsExplainedAndDrawnAsItsSession) {
  const std::string scene = "signed-distance --set Q=1,2/3,1 ";
  const std::string explanation = run("explain " + scene).out;
  for (const std::string picture : {"a.png", "a.svg", "a.pdf"}) {
    SCOPED_TRACE(picture);
    EXPECT_EQ(run("render " + scene + "--step 2 -o " + picture).status, 0);
    const Ran explained = run("explain " + picture);
    EXPECT_EQ(explained.status, 0) << explained.err;
    EXPECT_EQ(explained.out, explanation);
    // The step goes with it: drawn again, it is the same file, with the same session in it.
    EXPECT_EQ(run("render " + picture + " -o again-" + picture).status, 0);
    EXPECT_EQ(file("again-" + picture), file(picture));
  }
}

TEST_F(ReopenedPicture, OfAFlightsFrame_IsThatFrame) {
  EXPECT_EQ(run("render photon-torpedo --set seed=7 --frames 38:39 -o %02d.svg").status, 0);
  EXPECT_EQ(run("explain 38.svg").out, run("explain photon-torpedo --set seed=7 --set frame=38").out);
  EXPECT_NE(run("explain 38.svg").out, run("explain 39.svg").out);
}

TEST_F(ReopenedPicture, OfAFlatPicture_IsItsScene) {
  EXPECT_EQ(run("render ray-plane-picture --flat -o flat.png").status, 0);
  EXPECT_EQ(run("explain flat.png").out, run("explain ray-plane-picture").out);
}

TEST_F(ReopenedPicture, DrawnAnonymously_HoldsNothing) {
  for (const std::string picture : {"a.png", "a.svg", "a.pdf"}) {
    EXPECT_EQ(run("render signed-distance --anonymous -o " + picture).status, 0);
    EXPECT_EQ(file(picture).find("halfspace-session"), std::string::npos);
    EXPECT_EQ(file(picture).find("x-halfspace"), std::string::npos);
    expectRefused("explain " + picture, picture + ": This picture holds no scene of Halfspace.");
  }
}

TEST_F(ReopenedPicture, ThatIsDamaged_IsRefusedInASentence) {
  EXPECT_EQ(run("render signed-distance -o a.png").status, 0);
  std::string png = file("a.png");
  const auto place = png.find("halfspace-session");
  ASSERT_NE(place, std::string::npos);
  png[place + 40] = static_cast<char>(png[place + 40] ^ 1);
  write("a.png", png);
  expectRefused("explain a.png", "a.png: The scene in this picture is damaged");
  expectRefused("render a.png -o b.png", "a.png: The scene in this picture is damaged");
  expectRefused("a.png", "a.png: The scene in this picture is damaged");
}

} // namespace
} // namespace halfspace
