// Parts of figures that the command line switches on and off, and labels that a session has by hand.
#include "tests/app/command_fixture.h"

namespace halfspace {
namespace {

struct ShownInFigures : Program {
  /// The figure of a subject, with these options.
  std::string figure(const std::string &subject, const std::string &options,
                     const std::string &ending) const {
    const Ran ran = run("render " + subject + " --anonymous -o a" + ending + " " + options);
    EXPECT_EQ(ran.status, 0) << ran.err;
    return file("a" + ending);
  }
  static bool hasLabel(const std::string &svg, const std::string &label) {
    return svg.find("aria-label=\"" + label + "\"") != std::string::npos;
  }
};

TEST_F(ShownInFigures, OfVectors_AreAsAskedFor) {
  const std::string usual = figure("signed-distance", "", ".svg");
  EXPECT_TRUE(hasLabel(usual, "Q") && hasLabel(usual, "x") && hasLabel(usual, "10"));
  const std::string coordinates = figure("signed-distance", "--show coordinates", ".svg");
  EXPECT_TRUE(hasLabel(coordinates, "Q(11, 15, 8)")) << coordinates;
  const std::string unlabelled = figure("signed-distance", "--without labels", ".svg");
  EXPECT_TRUE(!hasLabel(unlabelled, "Q") && hasLabel(unlabelled, "x") && hasLabel(unlabelled, "10"));
  const std::string bare = figure("signed-distance", "--without axes,grid", ".svg");
  EXPECT_TRUE(hasLabel(bare, "Q") && !hasLabel(bare, "x") && !hasLabel(bare, "10"));
  EXPECT_LT(bare.size(), usual.size());
}

TEST_F(ShownInFigures, OfPixels_AreAsAskedFor) {
  const std::string usual = figure("signed-distance", "--size 320x200", ".png");
  for (const std::string options : {"--show coordinates", "--show drop-lines", "--without labels",
                                    "--without axes", "--without grid", "--without shadows"})
    EXPECT_NE(figure("signed-distance", "--size 320x200 " + options, ".png"), usual) << options;
  EXPECT_EQ(figure("signed-distance", "--size 320x200 --show labels,axes", ".png"), usual);
}

TEST_F(ShownInFigures, OfAFlatPicture_AreItsLabels) {
  EXPECT_TRUE(hasLabel(figure("ray-plane-picture", "--flat", ".svg"), "G"));
  EXPECT_FALSE(hasLabel(figure("ray-plane-picture", "--flat --without labels", ".svg"), "G"));
}

TEST_F(ShownInFigures, OfASession_HaveItsLabelsByHand_InPixelsAndInVectors) {
  const auto session = [&](const std::string &labels) {
    write("a.halfspace", R"({"format":"halfspace","version":5,"lesson":"signed-distance","step":0,"scene":[
      {"name":"E","plane":{"P0":[5,4,7],"n":[1,2,2]}},{"name":"Q","point":[11,15,8]},
      {"name":"distance","construction":"signed-distance","of":{"E":"E","Q":"Q"}}],"labels":)" +
                             labels + "}");
    return std::pair(figure("a.halfspace", "", ".svg"), figure("a.halfspace", "--size 320x200", ".png"));
  };
  const auto usual = session("{}");
  const auto moved = session(R"({"Q":{"at":[4,-3],"side":"left"}})");
  const auto hidden = session(R"({"Q":{"hidden":true}})");
  EXPECT_TRUE(hasLabel(usual.first, "Q") && hasLabel(moved.first, "Q") && !hasLabel(hidden.first, "Q"));
  EXPECT_NE(moved.first, usual.first);
  EXPECT_NE(moved.second, usual.second);
  EXPECT_NE(hidden.second, usual.second);
  EXPECT_NE(hidden.second, moved.second);
}

TEST_F(ShownInFigures, OfPartsThatAreNone_AreRefusedInASentence) {
  expectRefused("render signed-distance -o a.svg --without walls", "--without takes some of labels");
  expectRefused("render signed-distance -o a.svg --show axes --without grid,axes", "“axes” is to be shown");
}

} // namespace
} // namespace halfspace
