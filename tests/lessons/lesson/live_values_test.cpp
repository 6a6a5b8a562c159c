#include "tests/lessons/lesson/filled_text.h"
#include "tests/lessons/scenes.h"

#include "lessons/lesson/lesson.h"
#include "lessons/term/among_words.h"
#include "lessons/term/written.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace halfspace {
namespace {

using Kind = MarkdownSpan::Kind;
using Spans = std::vector<MarkdownSpan>;

/// t is 3, x about 0.125, and the side a word.
LiveValue someValues(const std::string &name) {
  return name == "t"   ? LiveValue(LiveNumber{number(3)})
         : name == "x" ? LiveValue(LiveNumber{amongWords(number(Rational(1234567890123, 9876543210987)))})
                       : LiveValue("positive");
}

std::string withSomeValues(const std::string &markdown) {
  return test::textOf(filledIn(*readMarkdown(markdown), someValues));
}

std::string filled(const std::string &markdown) {
  const Scene scene = test::distanceScene();
  return test::filledText(markdown, scene, evaluate(scene));
}

TEST(LiveValues, OfNumbersVectorsAndWords_StandInThePlaceOfTheirNames) {
  EXPECT_EQ(filled("f is {f}."), "f is $30$.");
  EXPECT_EQ(filled("{side}: {case}"), "positive: positive");
  EXPECT_EQ(filled("{foot.z}"), "$4/3$");
}

TEST(LiveValues, OfCoordinates_GoByShortAndFullNames) {
  EXPECT_EQ(filled("{Q} {E.n} {n}"),
            "$\\left(11,\\,15,\\,8\\right)$ $\\left(1,\\,2,\\,2\\right)$ $\\left(1,\\,2,\\,2\\right)$");
}

TEST(LiveValues, OfWhatConstructionsMake_GoByTheirNames_AndAreHiddenLikeOtherResults) {
  EXPECT_EQ(filled("{distance.F}"), "$\\left(23/3,\\,25/3,\\,4/3\\right)$");
  const Scene scene = test::distanceScene();
  EXPECT_EQ(liveValue("distance.F", scene, evaluate(scene), LiveValues::Hidden), LiveValue("?"));
}

TEST(LiveValues, ThatAreThere_AreAllNamedOnce_WithWhatTheyAre) {
  const Evaluation evaluation = evaluate(test::distanceScene());
  const std::vector<std::string> names = liveNames(evaluation);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  std::vector<std::string> texts;
  for (const std::string &name : names)
    texts.push_back(liveText(name, evaluation));
  for (const char *expected : {"Q = (11, 15, 8)", "n = (1, 2, 2)", "f = 30", "side = positive",
                               "signed_distance = 10", "distance.F = (23/3, 25/3, 4/3)"})
    EXPECT_NE(std::find(texts.begin(), texts.end(), expected), texts.end()) << expected;
}

TEST(LiveValues, OfBoundPoints_AreTheirFreedomsAndTheirPlace) {
  Object half = *makeObject("point-on-line");
  half[0].x = Rational(1, 2);
  const Scene scene{{{"g", LineObject{{1, 0, 0}, {4, 0, 2}}}, {"P", half, "g"}}};
  const auto shown = [&](const std::string &markdown) {
    return test::filledText(markdown, scene, evaluate(scene));
  };
  EXPECT_EQ(shown("{lambda} {P.lambda}"), "$1/2$ $1/2$");
  EXPECT_EQ(shown("{P.at} {at.x}"), "$\\left(3,\\,0,\\,1\\right)$ $3$");
  EXPECT_EQ(shown("{P.case} {g.case}"), "— —") << "objects have no case";
}

TEST(LiveValues, InFormulasCodeAndAddresses_AreLeftAlone) {
  EXPECT_EQ(filled("$\\frac{f}{2}$"), "$\\frac{f}{2}$");
  EXPECT_EQ(filled("$$\\frac{f}{2}$$"), "$\\frac{f}{2}$");
  for (const char *text : {"`{f}`", "\\{f}", "```\n{f}\n```", "~~~\n{f}\n~~~"})
    EXPECT_EQ(filled(text), "{f}") << text;
  EXPECT_EQ(filled("``a ` {f}``"), "a ` {f}");
  EXPECT_EQ(
      filledIn(*readMarkdown("[a](https://b.c/{side}) ![d]({side}.png)"), someValues).blocks.at(0).spans,
      (Spans{{Kind::Text, "a", 0, {.link = "https://b.c/{side}"}},
             {Kind::Text, " "},
             {Kind::Picture, "d", 0, {}, "{side}.png"}}));
  EXPECT_EQ(filled("$x${f}$y$"), "$x$$30$$y$");
}

TEST(LiveValues, WithoutAValueInThisCase_AreADash) { EXPECT_EQ(filled("{t} {perp.uu}"), "— —"); }

TEST(LiveValues, WhileTheLearnerLooksForThem_AreQuestionMarks_AndTheSceneIsAsItStands) {
  const Scene scene = test::distanceScene();
  EXPECT_EQ(test::filledText("f is {f}, {side}: {Q}, {t}", scene, evaluate(scene), LiveValues::Hidden),
            "f is ?, ?: $\\left(11,\\,15,\\,8\\right)$, —");
}

TEST(LiveValues, BracesThatHoldNoName_Stay) { EXPECT_EQ(filled("{1} {} {a b} {"), "{1} {} {a b} {"); }

TEST(LiveValues, WhenRounded_SaySo) {
  const Evaluation outcome = test::withValues({{"x", "", Surd(Rational(1234567890123, 9876543210987))}});
  EXPECT_EQ(test::filledText("{x}", Scene{}, outcome).substr(0, 9), "$\\approx ");
}

TEST(LiveValues, OfRoots_SayHowLargeTheyAre) {
  const Evaluation outcome = test::withValues({{"x", "", Surd::root(6, 3)}});
  EXPECT_EQ(test::filledText("It is {x}.", Scene{}, outcome), "It is $3\\sqrt{6}\\approx 7.348$.");
}

TEST(FilledWords, WithARoundedNumberBehindAnEqualSign_HaveItsOwnSignAlone) {
  EXPECT_EQ(withSomeValues("t = {t}, x = {x}."), "t = $3$, x $\\approx 0.125$.");
  EXPECT_EQ(withSomeValues("$t$ = {t}, $x$ = {x}."), "$t = 3$, $x \\approx 0.125$.");
  EXPECT_EQ(withSomeValues("x = **{x}**"), "x $\\approx 0.125$");
  EXPECT_EQ(withSomeValues("= {x}"), "$\\approx 0.125$");
  EXPECT_EQ(withSomeValues("$\\vec v =$ {x}, $\\vec w =$ {t}"), "$\\vec v  \\approx 0.125$, $\\vec w =$ $3$");
  EXPECT_EQ(withSomeValues("{side} = {x}"), "positive $\\approx 0.125$");
  EXPECT_EQ(withSomeValues("$x$ < {x}"), "$x < \\approx 0.125$");
}

TEST(FilledWords, WithAWordBesideARelation_AreTextThere) {
  EXPECT_EQ(withSomeValues("$s$ = {side}. So"), "$s$ = positive. So");
  EXPECT_EQ(withSomeValues("{side} = $s$. So"), "positive = $s$. So");
  EXPECT_EQ(withSomeValues("{side}"), "positive");
  EXPECT_EQ(withSomeValues("$s$ {side}, $t$ {t}"), "$s$ positive, $t$ $3$");
}

TEST(FilledWords, KeepTheLookOfTheirPlace) {
  const FilledMarkdown filled = filledIn(*readMarkdown("a *{side}* [{t}](https://b.c)"), someValues);
  EXPECT_EQ(filled.blocks.at(0).spans, (Spans{{Kind::Text, "a "},
                                              {Kind::Text, "positive", 0, {.emphasized = true}},
                                              {Kind::Text, " "},
                                              {Kind::Formula, "", 0, {.link = "https://b.c"}}}));
  EXPECT_EQ(withSomeValues("| a | b |\n|---|---|\n| {t} | is {side}. |"), "a\nb\n$3$\nis positive.");
}

TEST(FilledWords, WithANumberAloneInItsParagraph_AreLargeThere) {
  const auto isLarge = [](const char *markdown) {
    return filledIn(*readMarkdown(markdown), someValues).formulas.at(0).large;
  };
  EXPECT_TRUE(isLarge("Words\n\n{t}\n\nmore"));
  EXPECT_FALSE(isLarge("Words\n{t}"));
}

TEST(FilledWords, WithOtherValues_DifferInTheirFormulasAlone_AsLongAsThoseAreNumbers) {
  const Markdown markdown = *readMarkdown("$t$ = {t}, and {t} or {x}");
  const auto with = [&](const LiveValue &t) {
    return filledIn(markdown, [&](const std::string &name) { return name == "t" ? t : someValues(name); });
  };
  const FilledMarkdown three = with(LiveNumber{number(3)});
  EXPECT_EQ(three, with(LiveNumber{number(3)}));
  const FilledMarkdown five = with(LiveNumber{number(5)});
  EXPECT_EQ(three.blocks, five.blocks);
  EXPECT_NE(three.formulas[0], five.formulas[0]);
  EXPECT_EQ(three.formulas[2], five.formulas[2]);
  EXPECT_NE(three.blocks, with("?").blocks);
}

TEST(FilledWords, WithoutValues_HaveTheNamesInBraces) {
  EXPECT_EQ(test::textOf(withNames(*readMarkdown("So $t$ = {t}, or {distance.f}."))),
            "So $t$ = {t}, or {distance.f}.");
}

TEST(FilledWords, ReadOut_AreTheirTermsInPlainText) {
  const auto plain = [](const char *markdown) {
    return plainText(filledIn(*readMarkdown(markdown), someValues).formulas.at(0));
  };
  EXPECT_EQ(plain("$\\frac{a}{b}$ = {t}."), "a/b = 3.");
  EXPECT_EQ(plain("$x$ = {x}, so"), "x ≈ 0.125,");
  const LiveNumber twosRoot{root(number(2)), decimalOf(Surd::root(2), 4).term};
  EXPECT_EQ(plainText(twosRoot), "√2 ≈ 1.414");
}

} // namespace
} // namespace halfspace
