// Handouts from the command line.
#include "tests/app/command_fixture.h"

namespace halfspace {
namespace {

class Handouts : public Program {
protected:
  /// The words of a file; empty where nobody can read them.
  [[nodiscard]] std::string wordsOf(const std::string &name) const {
    return shell("pdftotext '" + name + "' - >.out 2>.err").out;
  }
  [[nodiscard]] static bool contains(const std::string &text, const std::string &part) {
    return text.find(part) != std::string::npos;
  }
};

TEST_F(Handouts, AreTheSameBytesAgain_AndCarryTheirScene) {
  const std::string scene = "signed-distance --set Q=1,2/3,1";
  EXPECT_EQ(run("handout " + scene + " -o a.pdf").status, 0);
  EXPECT_EQ(run("handout " + scene + " -o b.pdf").status, 0);
  EXPECT_EQ(file("a.pdf"), file("b.pdf"));
  EXPECT_EQ(run("explain a.pdf").out, run("explain " + scene).out);
  EXPECT_EQ(run("handout a.pdf -o again.pdf").status, 0);
  EXPECT_EQ(file("again.pdf"), file("a.pdf"));
}

TEST_F(Handouts, DrawnAnonymously_HoldNoScene) {
  EXPECT_EQ(run("handout signed-distance --anonymous -o a.pdf").status, 0);
  EXPECT_FALSE(contains(file("a.pdf"), "x-halfspace"));
}

TEST_F(Handouts, OfASession_HaveItsLabelsByHand) {
  const auto handout = [&](const std::string &labels) {
    write("a.halfspace", R"({"format":"halfspace","version":5,"lesson":"signed-distance","step":0,"scene":[
      {"name":"E","plane":{"P0":[5,4,7],"n":[1,2,2]}},{"name":"Q","point":[11,15,8]},
      {"name":"distance","construction":"signed-distance","of":{"E":"E","Q":"Q"}}],"labels":)" +
                             labels + "}");
    EXPECT_EQ(run("handout a.halfspace --anonymous --steps 2 -o a.pdf").status, 0);
    return file("a.pdf");
  };
  EXPECT_NE(handout(R"({"Q":{"at":[4,-3],"side":"left"}})"), handout("{}"));
}

TEST_F(Handouts, HaveThePaperAndTheColumnsThatAreAsked) {
  EXPECT_EQ(run("handout ray-sphere -o a.pdf").status, 0);
  EXPECT_EQ(run("handout ray-sphere -o b.pdf --paper letter --columns 2").status, 0);
  EXPECT_TRUE(contains(file("a.pdf"), "/MediaBox[0 0 595.28 841.89]"));
  EXPECT_TRUE(contains(file("b.pdf"), "/MediaBox[0 0 612 792]"));
  EXPECT_EQ(run("handout ray-sphere -o c.pdf --paper letter").status, 0);
  EXPECT_NE(file("b.pdf"), file("c.pdf")) << "one column";
}

TEST_F(Handouts, OfChosenSteps_HaveThese) {
  EXPECT_EQ(run("handout ray-sphere --steps 3,1-2 -o a.pdf").status, 0);
  const std::string pdf = file("a.pdf");
  std::size_t bookmarks = 0;
  for (auto place = pdf.find("/XYZ "); place != std::string::npos; place = pdf.find("/XYZ ", place + 1))
    ++bookmarks;
  EXPECT_EQ(bookmarks, 3U);
}

TEST_F(Handouts, TellAnswers_OnlyWhereTheyAreAskedTo) {
  EXPECT_EQ(run("handout ray-sphere -o a.pdf").status, 0);
  EXPECT_EQ(run("handout ray-sphere --answers -o b.pdf").status, 0);
  const std::string without = wordsOf("a.pdf");
  if (without.empty())
    GTEST_SKIP() << "pdftotext is not installed";
  EXPECT_TRUE(contains(without, "Question 1."));
  EXPECT_FALSE(contains(without, "Answer:"));
  EXPECT_TRUE(contains(wordsOf("b.pdf"), "Answer:"));
}

TEST_F(Handouts, TellWhatTheSceneComesTo) {
  EXPECT_EQ(run("handout signed-distance --answers -o a.pdf --set Q=1,1,1").status, 0);
  const std::string told = wordsOf("a.pdf");
  if (told.empty())
    GTEST_SKIP() << "pdftotext is not installed";
  EXPECT_TRUE(contains(told, "(−4, −3, −6) = −22")) << told; // Q − P₀
}

TEST_F(Handouts, ThatCannotBeMade_AreRefusedInASentence) {
  expectRefused("handout", "subject");
  expectRefused("handout ray-sphere", "--output");
  expectRefused("handout nowhere -o a.pdf", "There is no lesson “nowhere”");
  expectRefused("handout ray-sphere -o a.png", "let the name end in .pdf");
  ASSERT_EQ(run("render ray-sphere -o own.pdf").status, 0);
  const std::string before = file("own.pdf");
  expectRefused("handout own.pdf -o ./own.pdf", "a handout cannot be written over it");
  EXPECT_EQ(file("own.pdf"), before);
  expectRefused("handout ray-sphere -o a.pdf --steps x", "--steps takes numbers of steps");
  expectRefused("handout ray-sphere -o a.pdf --steps 0", "--steps takes numbers of steps");
  expectRefused("handout ray-sphere -o a.pdf --steps 3-1", "--steps takes numbers of steps");
  expectRefused("handout ray-sphere -o a.pdf --steps 1,", "--steps takes numbers of steps");
  expectRefused("handout ray-sphere -o a.pdf --steps 1-99", "The lesson has 9 steps");
  expectRefused("handout ray-sphere -o a.pdf --paper a3", "--paper");
  expectRefused("handout ray-sphere -o a.pdf --columns 3", "--columns");
  expectRefused("handout ray-sphere -o a.pdf --hidden no", "dashed, paler or left-out");
  expectRefused("handout ray-sphere -o no-such-folder/a.pdf", "no-such-folder/a.pdf");
  write("own.halfspace", R"({"format": "halfspace-session", "version": 1})");
  expectRefused("handout own.halfspace -o a.pdf", "own.halfspace");
}

TEST_F(Handouts, OfAnOwnLesson_HaveItsWords) {
  ASSERT_EQ(run("new-lesson mine").status, 0);
  EXPECT_EQ(run("handout mine.md -o a.pdf").status, 0);
  EXPECT_TRUE(file("a.pdf").starts_with("%PDF-1.7"));
}

} // namespace
} // namespace halfspace
