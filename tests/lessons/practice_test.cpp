#include "lessons/practice.h"

#include "lessons/lesson.h"
#include "lessons/session.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using Ids = std::set<std::string>;

Surd root(int square, const Rational &factor = 1) { return Surd::root(square, factor); }

TEST(ParseAnswer, OfNumbersAsLearnersWriteThem_IsExact) {
  const std::vector<std::pair<const char *, Surd>> cases{{"10", 10},
                                                         {" -10 / 3 ", Rational(-10, 3)},
                                                         {"−10/3", Rational(-10, 3)},
                                                         {"10/-3", Rational(-10, 3)},
                                                         {"3.25", Rational(13, 4)},
                                                         {"2*sqrt(43)/3", root(43, Rational(2, 3))},
                                                         {"(2√43)/3", root(43, Rational(2, 3))},
                                                         {"2/3·√43", root(43, Rational(2, 3))},
                                                         {"-sqrt43", root(43, -1)},
                                                         {"30/√43", root(43, Rational(30, 43))},
                                                         {"√(4/9)", Rational(2, 3)},
                                                         {"√2√3", root(6)},
                                                         {"1 - 2√2", root(2, -2) + Rational(1)}};
  for (const auto &[text, value] : cases) {
    const auto parsed = parseAnswer(text);
    ASSERT_TRUE(parsed) << text;
    EXPECT_TRUE(*parsed == value) << text;
  }
}

TEST(ParseAnswer, OfAnythingElse_IsNothing) {
  for (const char *text : {"", "-", "x", "1/0", "1/√0", "√-2", "√", "3..5", "2*", "(2", "2)", "1+", "√2+√3",
                           "√√2", "(1+√2)*2", "1e5", "nan"})
    EXPECT_FALSE(parseAnswer(text)) << text;
  EXPECT_FALSE(parseAnswer(std::string(longestAnswer + 1, '1')));
}

/// The line of a lesson's start, after some coordinates were given values.
WorkingLine lineOf(const std::string &lesson, const std::string &id, const std::vector<Edit> &edits = {}) {
  Session session{lesson, 0, readLessons(LESSON_FOLDER).find(lesson)->scene};
  for (const Edit &edit : edits)
    session = apply(session, edit);
  for (const WorkingLine &line : evaluate(session.scene).working.lines)
    if (line.id == id)
      return line;
  throw std::out_of_range(id);
}

Judgement judged(const WorkingLine &line, std::string_view typed) { return judge(line.blank.value(), typed); }

TEST(Judge, OfTheSignedDistance_TellsTheUsualMistakesApart) {
  const WorkingLine line = lineOf("signed-distance", "distance");
  EXPECT_TRUE(judged(line, "10").right);
  EXPECT_TRUE(judged(line, "30/3").right);
  EXPECT_EQ(judged(line, "30").sentence, "30 is f(Q): n is not normalized, so divide by |n|.");
  EXPECT_EQ(judged(line, "-10").sentence, "−10 has the wrong sign: the distance has the sign of f(Q).");
  EXPECT_NE(judged(line, "10/3").sentence.find("f(Q)/(n·n)"), std::string::npos);
  EXPECT_EQ(judged(line, "7").sentence, "7 is not right. Put the numbers into the symbols once more.");
  EXPECT_FALSE(judged(line, "7").right);
}

TEST(Judge, OfTheDistanceBehindThePlane_NoticesTheLostSignOfF) {
  const WorkingLine line =
      lineOf("signed-distance", "distance", {{"Q", PointObject{{-1, 1, 1}}}}); // f = −6 − 6 − 12 = −24
  EXPECT_TRUE(judged(line, "-8").right);
  EXPECT_NE(judged(line, "24").sentence.find("without its sign"), std::string::npos);
}

TEST(Judge, OfARoot_TakesADecimalThatRoundsRightAndSaysSo) {
  const Blank blank{{root(43, Rational(2, 3))}}; // 4.3716…
  EXPECT_EQ(judge(blank, "2√43/3").sentence, "Right.");
  const Judgement rounded = judge(blank, "4.37");
  EXPECT_TRUE(rounded.right);
  EXPECT_NE(rounded.sentence.find("rounded"), std::string::npos);
  EXPECT_NE(rounded.sentence.find("√43"), std::string::npos);
  EXPECT_FALSE(judge(blank, "4.38").right);
  EXPECT_FALSE(judge(blank, "4").right) << "a whole number is no rounded one";
  EXPECT_FALSE(judge({{Rational(1, 30)}}, "0.0").right) << "too few digits";
}

TEST(Judge, OfTheRaysParameter_TellsSignInverseAndNumerator) {
  const WorkingLine line = lineOf("ray-plane-dot", "t"); // −30/9
  EXPECT_TRUE(judged(line, "-10/3").right);
  EXPECT_NE(judged(line, "10/3").sentence.find("lost its sign"), std::string::npos);
  EXPECT_NE(judged(line, "-0.3").sentence.find("upside down"), std::string::npos);
  EXPECT_NE(judged(line, "-30").sentence.find("only the numerator"), std::string::npos);
}

TEST(Judge, OfThePlanesConstant_TellsSignAndNormalization) {
  const WorkingLine line = lineOf("plane-implicit", "collect");
  EXPECT_TRUE(judged(line, "-27").right);
  EXPECT_NE(judged(line, "27").sentence.find("minus sign"), std::string::npos);
  EXPECT_NE(judged(line, "16").sentence.find("adds up"), std::string::npos);
  EXPECT_NE(judged(line, "-9").sentence.find("normalized"), std::string::npos);
  const WorkingLine normalized = lineOf("plane-implicit", "normalized");
  EXPECT_TRUE(judged(normalized, "-9").right);
  EXPECT_NE(judged(normalized, "-27").sentence.find("not normalized"), std::string::npos);
}

TEST(Judge, OfTheTrianglesShares_TellsSwapSignAndNumerator) {
  const WorkingLine s = lineOf("ray-triangle-perp", "s");
  const WorkingLine t = lineOf("ray-triangle-perp", "t");
  const std::string sText = *toText(s.blank->answer.front());
  const std::string tText = *toText(t.blank->answer.front());
  EXPECT_TRUE(judged(s, sText).right);
  EXPECT_NE(judged(s, tText).sentence.find("is t"), std::string::npos);
  EXPECT_NE(judged(t, sText).sentence.find("is s"), std::string::npos);
  EXPECT_NE(judged(s, "-" + sText).sentence.find("D = "), std::string::npos);
  const Surd denominator = lineOf("ray-triangle-perp", "denominator").blank->answer.front();
  const Surd numerator = s.blank->answer.front() * denominator.rationalPart();
  EXPECT_NE(judged(s, *toText(numerator)).sentence.find("only the numerator"), std::string::npos);
}

TEST(Judge, OfAPoint_TakesItsCoordinatesAndNamesMistakesOfTheWholePoint) {
  const WorkingLine u = lineOf("ray-triangle-perp", "u"); // P1 − P0 = (−8, 0, 4)
  EXPECT_TRUE(judged(u, "(-8, 0, 4)").right);
  EXPECT_TRUE(judged(u, " -8 , 0; 4").sentence.find("no list") != std::string::npos);
  EXPECT_TRUE(judged(u, "-8; 0; 4").right);
  EXPECT_NE(judged(u, "(8, 0, -4)").sentence.find("the other way"), std::string::npos);
  EXPECT_NE(judged(u, "(1, 9, 4)").sentence.find("P₀ is left out"), std::string::npos);
  EXPECT_NE(judged(u, "(1, 1, 1)").sentence.find("not right"), std::string::npos);
  EXPECT_NE(judged(u, "4").sentence.find("3 numbers"), std::string::npos);
  EXPECT_NE(judged(lineOf("ray-triangle-perp", "uu"), "(1, 2, 3)").sentence.find("One number"),
            std::string::npos);
}

TEST(Judge, OfNoNumber_SaysHowToWriteOne) {
  const Judgement judgement = judge({{10}}, "ten");
  EXPECT_FALSE(judgement.right);
  EXPECT_NE(judgement.sentence.find("“ten” is not a number"), std::string::npos);
}

TEST(WithTellingMistakes, LeavesOutWhatComesToTheAnswerOrToAnEarlierOne) {
  Working working{{{"a", {Chain(1)}, "", Blank{{1}, {{{1}, "same"}, {{2}, "first"}, {{2}, "second"}}}}}};
  working = withTellingMistakes(std::move(working));
  ASSERT_EQ(working.lines[0].blank->mistakes.size(), 1U);
  EXPECT_EQ(working.lines[0].blank->mistakes[0].sentence, "first");
}

/// a = 1, b = 2, b > 0, c = (2, 2, 2)
Working fourLines() {
  const Term a = name(letter("a"), Rational(1));
  const Term b = name(letter("b"), Rational(2));
  const Term c = name(letter("c"), ExactVec3(2, 2, 2));
  return {{{"a", {withResult(a)}, "", Blank{{1}}},
           {"b", {withResult(b)}, "", Blank{{2}}},
           {"side", {compared(b, 0)}},
           {"c", {withResult(c)}}}};
}

TEST(BlankLines, FadeFromNoneToTheLastThatAsksToAll) {
  EXPECT_EQ(blankLines(fourLines(), Fading::None, {}), Ids{});
  EXPECT_EQ(blankLines(fourLines(), Fading::Last, {}), (Ids{"b", "c"})) << "c would give b away";
  EXPECT_EQ(blankLines(fourLines(), Fading::All, {}), (Ids{"a", "b", "c"}))
      << "without numbers nothing is blank";
}

TEST(BlankLines, ThatAreOpenedStayOpen) {
  EXPECT_EQ(blankLines(fourLines(), Fading::Last, {"b"}), Ids{});
  EXPECT_EQ(blankLines(fourLines(), Fading::All, {"b"}), (Ids{"a", "c"}));
}

TEST(BlankLines, WhereNoneAsks_AreTheLastWithNumbers) {
  Working working = fourLines();
  working.lines[0].blank.reset();
  working.lines[1].blank.reset();
  EXPECT_EQ(blankLines(working, Fading::Last, {}), Ids{"c"});
  EXPECT_EQ(blankLines({}, Fading::Last, {}), Ids{});
}

} // namespace
} // namespace halfspace
