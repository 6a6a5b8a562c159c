#include "lessons/lesson/practice.h"

#include "lessons/lesson/lesson.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"

#include "tests/lessons/scenes.h"
#include "tests/lessons/spoken_to_in.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using Ids = std::set<std::string>;

Surd root(int square, const Rational &factor = 1) { return Surd::root(square, factor); }

Working workingOf(const std::string &lesson) {
  return test::ownLines(readLessons(LESSON_FOLDER).find(lesson)->scene);
}

/// The line of a lesson's start, after some coordinates were given values.
WorkingLine lineOf(const std::string &lesson, const std::string &id, const std::vector<Edit> &edits = {}) {
  const Working working = test::ownLines(test::edited(readLessons(LESSON_FOLDER).find(lesson)->scene, edits));
  if (const WorkingLine *line = findLine(working, id))
    return *line;
  throw std::out_of_range(id);
}

/// An answer to what the line asks for.
Judgement judged(const WorkingLine &line, std::string_view typed) {
  return judge(line, resultGap(line), typed);
}

/// A line that comes to a number.
WorkingLine lineTo(const Surd &number) {
  return {"x", {withResult(name(letter("x"), number))}, "", Asked::Value};
}

/// The number that the line comes to.
Surd exactOf(const WorkingLine &line) {
  return exactNumbers(line.chains.back().last()->value.value()).value().front();
}

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
  const WorkingLine line = lineOf("signed-distance", "distance",
                                  {ChangeObject{"Q", PointObject{{-1, 1, 1}}}}); // f = −6 − 6 − 12 = −24
  EXPECT_TRUE(judged(line, "-8").right);
  EXPECT_NE(judged(line, "24").sentence.find("without its sign"), std::string::npos);
}

TEST(Judge, OfARoot_TakesADecimalThatRoundsRightAndSaysSo) {
  const WorkingLine line = lineTo(root(43, Rational(2, 3))); // 4.3716…
  EXPECT_EQ(judged(line, "2√43/3").sentence, "Right.");
  const Judgement rounded = judged(line, "4.37");
  EXPECT_TRUE(rounded.right);
  EXPECT_NE(rounded.sentence.find("rounded"), std::string::npos);
  EXPECT_NE(rounded.sentence.find("√43"), std::string::npos);
  EXPECT_FALSE(judged(line, "4.38").right);
  EXPECT_FALSE(judged(line, "4").right) << "a whole number is no rounded one";
  EXPECT_FALSE(judged(lineTo(Rational(1, 30)), "0.0").right) << "too few digits";
}

TEST(Judge, OfTheRaysParameter_TellsSignInverseAndNumerator) {
  const WorkingLine line = lineOf("ray-plane-dot", "t"); // −30/9
  EXPECT_TRUE(judged(line, "-10/3").right);
  EXPECT_NE(judged(line, "10/3").sentence.find("lost its sign"), std::string::npos);
  EXPECT_NE(judged(line, "-0.3").sentence.find("upside down"), std::string::npos);
  EXPECT_NE(judged(line, "-30").sentence.find("only the numerator"), std::string::npos);
}

TEST(Judge, OfThePlanesEquation_TakesAnyMultipleOfIt) {
  const WorkingLine line = lineOf("plane-implicit", "collect");
  for (const char *right :
       {"x + 2y + 2z - 27", "x+2y+2z=27", "0 = x + 2*y + 2*z - 27", "27 = x+2y+2z", "-x - 2y - 2z + 27 = 0",
        "x/3 + 2/3 y + 2z/3 = 9", "2(x+2y+2z) = 54", "x+2(y+z)-27"})
    EXPECT_TRUE(judged(line, right).right) << right;
  EXPECT_EQ(judged(line, "x + 2y + 2z - 27").sentence, "Right.");
  EXPECT_NE(judged(line, "2x + 4y + 4z = 54").sentence.find("the same factor"), std::string::npos);
  for (const char *wrong : {"x + 2y + 2z", "x + 2y + 3z - 27", "xx + 2y + 2z - 27", "0 = 0"})
    EXPECT_FALSE(judged(line, wrong).right) << wrong;
  EXPECT_NE(judged(line, "x + 2y + 2z + 27 = 0").sentence.find("minus sign"), std::string::npos);
  EXPECT_NE(judged(line, "-x - 2y - 2z = 27").sentence.find("minus sign"), std::string::npos) << "a multiple";
  EXPECT_NE(judged(line, "x + 2y + 2z - 16").sentence.find("added up"), std::string::npos);
  EXPECT_TRUE(
      judged(lineOf("plane-implicit", "collect", {ChangeObject{"E", PlaneObject{{1, 2, 3}, {0, 0, 2}}}}),
             "0x + 0y + z = 3")
          .right)
      << "letters that drop out may be written";
  EXPECT_NE(judged(line, "plane").sentence.find("cannot be read"), std::string::npos)
      << "p·l·a·n·e is no sum";
  EXPECT_NE(judged(line, "(1, 2, 2)").sentence.find("One equation"), std::string::npos);
}

TEST(Judge, OfTheNormalizedEquation_TakesNoOtherMultiple) {
  const WorkingLine line = lineOf("plane-implicit", "normalized");
  EXPECT_TRUE(judged(line, "(x + 2y + 2z - 27)/3").right);
  EXPECT_TRUE(judged(line, "x/3 + 2y/3 + 2z/3 - 9 = 0").right);
  EXPECT_TRUE(judged(line, "0 = x/3 + 2y/3 + 2z/3 - 9").right);
  EXPECT_TRUE(judged(line, "9 = (x + 2y + 2z)/3").right);
  EXPECT_NE(judged(line, "x + 2y + 2z - 27").sentence.find("not normalized"), std::string::npos);
  EXPECT_NE(judged(line, "(x + 2y + 2z - 27)/9").sentence.find("n·n"), std::string::npos);
  EXPECT_NE(judged(line, "-(x + 2y + 2z - 27)/3").sentence.find("the other way"), std::string::npos);
}

TEST(Judge, OfTheEquationInT_ReadsItsLetter) {
  const WorkingLine line = lineOf("ray-plane-dot", "collect"); // 0 = 9t + 30
  EXPECT_TRUE(judged(line, "9t + 30").right);
  EXPECT_TRUE(judged(line, "3t = -10").right);
  EXPECT_NE(judged(line, "9x + 30").sentence.find("write it with t and numbers"), std::string::npos);
  EXPECT_NE(judged(line, "9t - 30").sentence.find("to be added"), std::string::npos);
}

TEST(Judge, OfTheTrianglesShares_TellsSwapSignAndNumerator) {
  const WorkingLine s = lineOf("ray-triangle-perp", "s");
  const WorkingLine t = lineOf("ray-triangle-perp", "t");
  const std::string sText = *toText(exactOf(s));
  const std::string tText = *toText(exactOf(t));
  EXPECT_TRUE(judged(s, sText).right);
  EXPECT_NE(judged(s, tText).sentence.find("is t"), std::string::npos);
  EXPECT_NE(judged(t, sText).sentence.find("is s"), std::string::npos);
  EXPECT_NE(judged(s, "-" + sText).sentence.find("G = "), std::string::npos);
  const Surd denominator = exactOf(lineOf("ray-triangle-perp", "denominator"));
  const Surd numerator = exactOf(s) * denominator.rationalPart();
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
  const Judgement judgement = judged(lineTo(10), "ten");
  EXPECT_FALSE(judgement.right);
  EXPECT_NE(judgement.sentence.find("“ten” is not a number"), std::string::npos);
}

TEST(Judge, OfADecimalCommaWhereItParts_SaysHowToWriteADecimal) {
  const WorkingLine line = lineTo(Rational(1, 2));
  EXPECT_NE(judged(line, "0,5").sentence.find("written as 2.5"), std::string::npos);
  {
    const test::SpokenToIn german(test::withDecimalComma());
    EXPECT_TRUE(judge(line, resultGap(line), "0,5").right);
  }
  for (const char *right : {"0.5", ".5", "1/2", "2/4", "4/8", "0.50", "1 / 2"})
    EXPECT_EQ(judged(line, right).sentence, "Right.") << right;
}

TEST(Judge, OfLettersWhereANumberIsAsked_SaysHowToWriteOne) {
  EXPECT_NE(judged(lineTo(10), "10x").sentence.find("is not a number"), std::string::npos);
  EXPECT_NE(judged(lineTo(10), "x = 10").sentence.find("is not a number"), std::string::npos);
}

TEST(Judge, OfMistakesThatComeToTheAnswer_PassesThemOver) {
  WorkingLine line = lineTo(3);
  line.mistakes = {{3, "same"}, {4, "first"}, {4, "second"}};
  EXPECT_EQ(judged(line, "3").sentence, "Right.");
  EXPECT_EQ(judged(line, "4").sentence, "first");
}

/// a = 1, b = 2, b > 0, c = 1 + 2·b = 1 + 2·2 = 5
Working fourLines() {
  const Term a = name(letter("a"), Rational(1));
  const Term b = name(letter("b"), Rational(2));
  const Term c = name(letter("c"), Rational(5));
  return {{{"a", {withResult(a)}, "", Asked::Value},
           {"b", {withResult(b)}, "", Asked::Value},
           {"side", {compared(b, 0)}},
           {"c", {withNumbers(c == 1 + 2 * b)}}}};
}

TEST(Fade, OfAGapInALine_LetsWhatComparesItsResultWait) {
  const Term a = name(letter("a"), Rational(2));
  const Term b = name(letter("b"), Rational(3));
  const Working lines{{{"product", {withNumbers(a * b)}, "", Asked::Value},
                       {"same", {compared(a * b, 6)}},
                       {"other", {compared(a, b)}}}};
  const Fade faded = fade(lines, Fading::Gaps, {});
  ASSERT_TRUE(faded.gaps.contains("product"));
  EXPECT_EQ(faded.waiting, Ids{"same"});
}

Ids gapsOf(const Fade &fade) {
  Ids ids;
  for (const auto &[line, gap] : fade.gaps)
    ids.insert(line);
  return ids;
}

TEST(Fade, GoesFromNoneToTheLastThatAsksToAll) {
  EXPECT_EQ(gapsOf(fade(fourLines(), Fading::None, {})), Ids{});
  EXPECT_EQ(gapsOf(fade(fourLines(), Fading::Last, {})), Ids{"b"});
  EXPECT_EQ(gapsOf(fade(fourLines(), Fading::All, {})), (Ids{"a", "b"}))
      << "what cannot be answered is no gap";
}

TEST(Fade, OfLinesThatWouldGiveAResultAway_LetsThemWait) {
  EXPECT_EQ(fade(fourLines(), Fading::Last, {}).waiting, (Ids{"c", "side"}));
  EXPECT_EQ(fade(fourLines(), Fading::Last, {"b"}).waiting, Ids{});
  EXPECT_EQ(fade(fourLines(), Fading::None, {}).waiting, Ids{});
}

TEST(Fade, OfLinesThatAreOpened_LeavesNothingOut) {
  EXPECT_EQ(gapsOf(fade(fourLines(), Fading::Last, {"b"})), Ids{});
  EXPECT_EQ(gapsOf(fade(fourLines(), Fading::All, {"b"})), Ids{"a"});
}

TEST(Fade, WhereNoLineAsks_LeavesNothingOut) {
  Working working = fourLines();
  for (std::size_t place = 0; place < working.lines.size(); ++place)
    working.lines.change(place, [](WorkingLine &line) { line.asked = Asked::Nothing; });
  EXPECT_EQ(gapsOf(fade(working, Fading::Last, {})), Ids{});
  EXPECT_EQ(gapsOf(fade({}, Fading::Last, {})), Ids{});
}

TEST(Fade, ByGaps_LeavesOneCalculatedNumberOfALineOut) {
  const Working working = workingOf("signed-distance");
  const Fade faded = fade(working, Fading::Gaps, {});
  EXPECT_EQ(faded.waiting, Ids{"side"}) << "it compares what another line calculates";
  for (const auto &[id, gap] : faded.gaps) {
    const WorkingLine &line = *findLine(working, id);
    EXPECT_FALSE(gap.isResult);
    EXPECT_TRUE(gap.hidden->origin && !gap.hidden->source) << "a coordinate is no calculation";
    const std::string truth = *toText(*numberOf(gap.hidden)->exact());
    EXPECT_TRUE(judge(line, gap, truth).right) << id << ": " << truth;
    EXPECT_FALSE(judge(line, gap, truth + "+1").right) << id;
  }
  EXPECT_TRUE(gapsOf(faded).contains("f"));
  EXPECT_FALSE(gapsOf(fade(working, Fading::Gaps, {"f"})).contains("f"));
}

TEST(Judge, OfAGapBehindAMinus_TypedWithTheMinus_SaysThatItIsThere) {
  const WorkingLine line{"x",
                         {withNumbers(name(letter("x"), Rational(3)) ==
                                      name(letter("a"), Rational(10)) - name(letter("b"), Rational(7)))}};
  for (const Gap &gap : numberGaps(askedChain(line))) {
    const std::string opposite = "-" + plainText(gap.hidden);
    const bool isBehindMinus = plainText(gap.hidden) == "7";
    EXPECT_EQ(judge(line, gap, opposite).sentence.starts_with("The minus stands before the gap already"),
              isBehindMinus)
        << opposite;
  }
}

TEST(Judge, OfAnotherCountOfNumbers_IsNoAnswer) {
  EXPECT_FALSE(judged(lineTo(10), "1, 2, 3").isAnswer);
  EXPECT_TRUE(judged(lineTo(10), "11").isAnswer);
}

TEST(Judge, OfANumberInAList_NamesTheMistakeInItsCoordinate) {
  const Working working = workingOf("signed-distance"); // (1, 2, 2)·(6, 11, 1) = 30
  const WorkingLine &f = *findLine(working, "f");
  for (const Gap &gap : numberGaps(askedChain(f)))
    if (gap.hidden->kind == TermKind::Number && plainText(gap.hidden) == "11") {
      EXPECT_TRUE(judge(f, gap, "11").right);
      EXPECT_NE(judge(f, gap, "19").sentence.find("adds where Q − P₀ subtracts"), std::string::npos);
      EXPECT_NE(judge(f, gap, "-11").sentence.find("the other way"), std::string::npos);
      return;
    }
  FAIL() << "there is no 11";
}

TEST(ToldFor, TheLargestOfSeveral_AreTheyAndNotWhatIsAsked) {
  const Working box = workingOf("ray-box-slabs");
  const WorkingLine &last = *findLine(box, "t-in");
  EXPECT_EQ(symbolsText(last), "t_in = max(in_x, in_y, in_z)");
  const auto told = toldFor(last, resultGap(last), {{last}});
  ASSERT_EQ(told.size(), 3U);
  EXPECT_EQ(plainText(told[0]), "in_x = 1");
}

TEST(ToldFor, ALine_AreTheNamesThatNoShownLineSays) {
  const Working plane = workingOf("plane-implicit");
  const WorkingLine &constant = *findLine(plane, "constant");
  const auto told = toldFor(constant, resultGap(constant), {{constant}});
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(plainText(told[0]), "n = (1, 2, 2)");
  EXPECT_EQ(plainText(told[1]), "P₁ = (5, 6, 5)");

  const Working distance = workingOf("signed-distance");
  const WorkingLine &last = *findLine(distance, "distance");
  const auto toldLast = toldFor(last, resultGap(last), {{last}});
  ASSERT_EQ(toldLast.size(), 2U);
  EXPECT_EQ(plainText(toldLast[0]), "f(Q) = 30");
  EXPECT_EQ(plainText(toldLast[1]), "n = (1, 2, 2)");
  ASSERT_EQ(toldFor(last, resultGap(last), distance).size(), 1U) << "the line of f says it, or asks for it";
}

} // namespace
} // namespace halfspace
