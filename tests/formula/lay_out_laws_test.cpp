// What holds of every layout, whatever the font's numbers are.
#include "tests/formula/laid_out.h"

namespace halfspace::math {
namespace {

const std::vector<std::string> samples{
    "x",
    "a+b=c",
    "\\frac{-b\\pm\\sqrt{b^2-4ac}}{2a}",
    "\\sqrt[3]{\\frac ab}",
    "\\sum_{i=1}^n\\lambda_i P_i",
    "\\left(\\frac p2\\right)^2_i",
    "\\vec u^{\\perp}\\cdot\\vec n_f",
    "\\begin{pmatrix}1&2\\\\3&4\\end{pmatrix}",
    "\\left[\\begin{array}{cc|c}1&2&3\\\\\\hline 4&5&6\\end{array}\\right]",
    "\\underbrace{a+b}_{n}+\\overbrace{c}^{k}",
    "\\overrightarrow{AB}+\\widehat{xyz}+\\overline{z}+\\underline{x}",
    "\\xrightarrow[\\text{below}]{abc}",
    "\\boxed{E=mc^2}",
    "\\int_0^1 f\\,dx",
    "\\text{Länge: длина}",
    "\\binom nk\\not\\perp f'^2_1"};

TEST(LayOut, AnEmptyFormula_HasNoSize) {
  const Layout layout = laidOut("");
  EXPECT_EQ(layout.width, 0);
  EXPECT_EQ(layout.ascent, 0);
  EXPECT_EQ(layout.depth, 0);
  EXPECT_TRUE(layout.glyphs.empty());
}

TEST(LayOut, TheBox_ContainsAllInkAboveAndBelow) {
  for (const std::string &sample : samples)
    for (const Style style : {Style::Display, Style::Text}) {
      const Layout layout = laidOut(sample, style);
      for (const PlacedGlyph &glyph : layout.glyphs) {
        EXPECT_GE(inkOf(glyph).y, -layout.ascent - rounding) << sample;
        EXPECT_LE(inkOf(glyph).bottom(), layout.depth + rounding) << sample;
      }
      for (const Rule &rule : layout.rules) {
        EXPECT_GE(rule.box.y, -layout.ascent - rounding) << sample;
        EXPECT_LE(rule.box.bottom(), layout.depth + rounding) << sample;
      }
    }
}

TEST(LayOut, TheBox_ContainsAllInkToBothSides) {
  // Accents and slanted letters may stand out by a hair, as their fonts want it.
  constexpr double overhang = 0.06;
  for (const std::string &sample : samples) {
    const Layout layout = laidOut(sample);
    for (const PlacedGlyph &glyph : layout.glyphs) {
      EXPECT_GE(inkOf(glyph).x, -overhang) << sample;
      EXPECT_LE(inkOf(glyph).right(), layout.width + overhang) << sample;
    }
    for (const Rule &rule : layout.rules)
      EXPECT_LE(rule.box.right(), layout.width + rounding) << sample;
  }
}

TEST(LayOut, TheSameFormula_IsLaidOutTheSame) {
  for (const std::string &sample : samples) {
    const Layout first = laidOut(sample);
    const Layout second = laidOut(sample);
    ASSERT_EQ(first.glyphs.size(), second.glyphs.size());
    for (std::size_t i = 0; i < first.glyphs.size(); ++i) {
      EXPECT_EQ(first.glyphs[i].glyph, second.glyphs[i].glyph);
      EXPECT_EQ(first.glyphs[i].x, second.glyphs[i].x);
      EXPECT_EQ(first.glyphs[i].y, second.glyphs[i].y);
    }
  }
}

TEST(LayOut, AGroupAroundEverything_ChangesNothing) {
  for (const std::string &sample : samples) {
    const Layout plain = laidOut(sample);
    const Layout grouped = laidOut("{" + sample + "}");
    EXPECT_NEAR(plain.width, grouped.width, rounding) << sample;
    EXPECT_NEAR(plain.ascent, grouped.ascent, rounding) << sample;
    EXPECT_NEAR(plain.depth, grouped.depth, rounding) << sample;
  }
}

TEST(Fraction, NumeratorAndDenominator_StandOnBothSidesOfTheAxis) {
  const Layout layout = laidOut("\\frac{g}{h}");
  ASSERT_EQ(layout.rules.size(), 1U);
  const Rectangle bar = layout.rules.front().box;
  EXPECT_NEAR(bar.y + bar.height / 2, -axisHeight(), rounding);
  EXPECT_LT(inkOf(letterIn(layout, 'g')).bottom(), bar.y);
  EXPECT_GT(inkOf(letterIn(layout, 'h')).y, bar.bottom());
}

TEST(Fraction, TheNarrowerPart_IsCentred) {
  const Layout layout = laidOut("\\frac{x}{abc+def}");
  const Rectangle bar = layout.rules.front().box;
  const PlacedGlyph x = letterIn(layout, 'x');
  const double advance = fonts().math.face().metrics(x.glyph).advance;
  EXPECT_NEAR(x.x + advance / 2, bar.x + bar.width / 2, 0.03);
}

TEST(Fraction, InText_IsSmaller) {
  EXPECT_LT(laidOut("\\frac{1}{2}", Style::Text).ascent, laidOut("\\frac{1}{2}").ascent);
  EXPECT_NEAR(laidOut("\\tfrac{1}{2}").ascent, laidOut("\\frac{1}{2}", Style::Text).ascent, rounding);
  EXPECT_NEAR(laidOut("\\dfrac{1}{2}", Style::Text).ascent, laidOut("\\frac{1}{2}").ascent, rounding);
}

TEST(Root, ItsBar_LiesOverTheRadicandAlone) {
  const Layout layout = laidOut("\\sqrt{a+b}c");
  ASSERT_EQ(layout.rules.size(), 1U);
  const Rectangle bar = layout.rules.front().box;
  EXPECT_LE(bar.x, letterIn(layout, 'a').x + rounding);
  EXPECT_GE(bar.right(), inkOf(letterIn(layout, 'b')).right());
  EXPECT_LE(bar.right(), letterIn(layout, 'c').x + rounding);
  EXPECT_LT(bar.bottom(), inkOf(letterIn(layout, 'b')).y);
}

TEST(Root, TheDegree_StandsLeftAndRaised) {
  const Layout layout = laidOut("\\sqrt[n]{x}");
  const PlacedGlyph degree = letterIn(layout, 'n');
  EXPECT_LT(inkOf(degree).right(), letterIn(layout, 'x').x);
  EXPECT_LT(degree.y, 0);
  EXPECT_LT(degree.size, 1);
}

TEST(Root, AWideDegree_StaysInsideTheFormula) {
  EXPECT_GE(inkOf(letterIn(laidOut("\\sqrt[abcdn]{x}"), 'a')).x, 0);
  EXPECT_GE(inkOf(letterIn(laidOut("\\sqrt[i]{x}"), 'i')).x, 0);
}

TEST(Scripts, StandOnBothSidesOfTheMiddleAndDoNotTouch) {
  const Layout layout = laidOut("x^a_b");
  const PlacedGlyph above = letterIn(layout, 'a');
  const PlacedGlyph below = letterIn(layout, 'b');
  EXPECT_LT(above.y, 0);
  EXPECT_GT(below.y, 0);
  EXPECT_GT(inkOf(below).y - inkOf(above).bottom(), 0.05);
  EXPECT_NEAR(above.size, 0.7, 0.01);
}

TEST(Scripts, OfScripts_AreSmallerAgain) {
  const Layout layout = laidOut("x^{a^b}");
  EXPECT_NEAR(letterIn(layout, 'b').size, 0.5, 0.01);
  EXPECT_LT(letterIn(layout, 'b').y, letterIn(layout, 'a').y);
}

TEST(Scripts, ASuperscript_RisesWithWhatItStandsOn) {
  EXPECT_LT(letterIn(laidOut("\\left(\\frac ab\\right)^n"), 'n').y, letterIn(laidOut("x^n"), 'n').y);
}

TEST(Scripts, OnAnAccentedLetter_StandAsOnTheLetter) {
  EXPECT_NEAR(letterIn(laidOut("\\vec u^n"), 'n').y, letterIn(laidOut("u^n", Style::Text), 'n').y, 0.1);
  EXPECT_NEAR(letterIn(laidOut("\\vec u_n"), 'n').y, letterIn(laidOut("u_n"), 'n').y, rounding);
}

TEST(Scripts, ALoneSubscript_IsLoweredLess) {
  EXPECT_LT(letterIn(laidOut("x_n"), 'n').y, letterIn(laidOut("x^a_n"), 'n').y);
}

TEST(Scripts, OfASum_AreLimitsInDisplayOnly) {
  const Layout display = laidOut("\\sum_a^b");
  const PlacedGlyph below = letterIn(display, 'a');
  const PlacedGlyph above = letterIn(display, 'b');
  EXPECT_NEAR(below.x, above.x, 0.2);
  EXPECT_GT(inkOf(below).y, 0.5);
  const Layout text = laidOut("\\sum_a^b", Style::Text);
  EXPECT_LT(inkOf(letterIn(text, 'a')).y, 0.5);
  EXPECT_NEAR(letterIn(laidOut("\\sum\\nolimits_a^b"), 'a').x,
              letterIn(laidOut("\\sum\\nolimits_a^b"), 'b').x, 0.2);
  EXPECT_GT(letterIn(laidOut("\\textstyle\\sum\\limits_a^b"), 'a').y, 0.5);
}

TEST(Scripts, OfAnIntegral_FollowItsSlant) {
  const Layout layout = laidOut("\\int_a^b");
  EXPECT_LT(letterIn(layout, 'a').x, letterIn(layout, 'b').x - 0.1);
}

TEST(LargeOperator, InDisplay_IsLargerAndCentredOnTheAxis) {
  const Layout display = laidOut("\\sum");
  const Layout text = laidOut("\\sum", Style::Text);
  EXPECT_GT(display.ascent + display.depth, 1.2 * (text.ascent + text.depth));
  EXPECT_NEAR((display.ascent - display.depth) / 2, axisHeight(), rounding);
}

TEST(Accent, AnArrow_StandsOverItsLetter) {
  const Layout layout = laidOut("\\vec u");
  ASSERT_EQ(layout.glyphs.size(), 2U);
  const Rectangle letter = inkOf(layout.glyphs[0]);
  const Rectangle arrow = inkOf(layout.glyphs[1]);
  EXPECT_LE(arrow.bottom(), letter.y + 0.02);
  EXPECT_NEAR(arrow.x + arrow.width / 2, letter.x + letter.width / 2, 0.12);
  EXPECT_NEAR(layout.width, laidOut("u").width, rounding);
}

TEST(Accent, OverATallLetter_IsHigher) {
  EXPECT_LT(laidOut("\\vec B").glyphs[1].y, laidOut("\\vec u").glyphs[1].y - 0.1);
}

TEST(Accent, AWideArrow_IsAsWideAsItsBase) {
  const Layout layout = laidOut("\\overrightarrow{ABCDEFG}");
  double left = layout.width;
  double right = 0;
  for (const PlacedGlyph &glyph : layout.glyphs)
    if (inkOf(glyph).bottom() < -0.6) {
      left = std::min(left, inkOf(glyph).x);
      right = std::max(right, inkOf(glyph).right());
    }
  EXPECT_NEAR(right - left, layout.width, 0.25);
}

TEST(Fences, Left_GrowsWithItsContent) {
  double last = 0;
  std::string rows = "a";
  for (int i = 0; i < 8; ++i, rows += "\\\\a") {
    const Layout layout = laidOut("\\left(\\begin{matrix}" + rows + "\\end{matrix}\\right)");
    const double height = layout.ascent + layout.depth;
    EXPECT_GT(height, last);
    last = height;
  }
}

TEST(Fences, AreCentredOnTheAxis) {
  const Layout layout = laidOut("\\left(\\frac{a}{b}\\right.");
  const Rectangle ink = inkOf(layout.glyphs.back());
  EXPECT_NEAR(ink.y + ink.height / 2, -axisHeight(), 0.01);
}

TEST(Fences, CoverNineTenthsOfTheirContent) {
  const Layout layout = laidOut("\\left|\\begin{matrix}a\\\\b\\\\c\\\\d\\end{matrix}\\right|");
  const Layout inside = laidOut("\\begin{matrix}a\\\\b\\\\c\\\\d\\end{matrix}");
  ASSERT_EQ(layout.rules.size(), 2U);
  EXPECT_GE(layout.rules.front().box.height, 0.9 * (inside.ascent + inside.depth));
}

TEST(Fences, StretchedBars_AreThinRules) {
  const Layout layout = laidOut("\\left\\|\\frac ab\\right|");
  ASSERT_EQ(layout.rules.size(), 4U); // the fraction's and three of bars
  for (std::size_t i = 1; i < layout.rules.size(); ++i)
    EXPECT_LT(layout.rules[i].box.width, 0.06);
}

TEST(Fences, AMiddleBar_IsAsTallAsTheOthers) {
  const Layout layout = laidOut("\\left|\\frac ab\\middle|c\\right|");
  ASSERT_EQ(layout.rules.size(), 4U);
  EXPECT_NEAR(layout.rules[1].box.height, layout.rules[2].box.height, rounding);
  EXPECT_NEAR(layout.rules[1].box.height, layout.rules[3].box.height, rounding);
}

TEST(Fences, MiddleBarsNestedDeeply_TakeNoTimeToSpeakOf) {
  std::string source;
  for (int i = 0; i < 50; ++i)
    source += "\\left(a\\middle|";
  source += "b";
  for (int i = 0; i < 50; ++i)
    source += "\\right)";
  EXPECT_FALSE(laidOut(source).glyphs.empty());
}

TEST(Fences, Big_HaveTheirOwnSizes) {
  const auto height = [](const std::string &source) {
    const Layout layout = laidOut(source);
    return layout.ascent + layout.depth;
  };
  EXPECT_GE(height("\\big("), 1.15);
  EXPECT_GT(height("\\Big("), height("\\big(") + 0.3);
  EXPECT_GT(height("\\bigg("), height("\\Big(") + 0.3);
  EXPECT_GT(height("\\Bigg("), height("\\bigg(") + 0.3);
}

TEST(Braces, AreAsWideAsTheirContentAndHaveTheirScriptBeyond) {
  const Layout layout = laidOut("\\underbrace{a+b+c+d}_{n}");
  const Rectangle script = inkOf(letterIn(layout, 'n'));
  EXPECT_GT(script.y, 0.3);
  EXPECT_NEAR(script.x + script.width / 2, layout.width / 2, 0.1);
}

TEST(Arrows, AreAsLongAsWhatIsWrittenOnThem) {
  EXPECT_GT(laidOut("\\xrightarrow{abcdefgh}").width, laidOut("abcdefgh", Style::Text).width * 0.7 + 0.5);
  EXPECT_GT(laidOut("\\xrightarrow{}").width, 1);
}

TEST(Phantom, TakesRoomAndShowsNothing) {
  const Layout layout = laidOut("\\phantom{\\frac{a}{b}}");
  EXPECT_TRUE(layout.glyphs.empty());
  EXPECT_TRUE(layout.rules.empty());
  EXPECT_NEAR(layout.width, laidOut("\\frac{a}{b}").width, rounding);
  EXPECT_NEAR(laidOut("\\vphantom{ab}").width, 0, rounding);
  EXPECT_NEAR(laidOut("\\hphantom{ab}").ascent, 0, rounding);
}

TEST(Lap, TakesNoRoomAndReachesToItsSide) {
  for (const char *lap : {"\\mathrlap", "\\mathllap", "\\mathclap"})
    EXPECT_NEAR(laidOut("a" + std::string(lap) + "{xyz}b").width, laidOut("ab").width, rounding);
  const double place = laidOut("a").width;
  EXPECT_NEAR(glyphIn(laidOut("a\\mathrlap{12}"), '1').x, place, rounding);
  EXPECT_NEAR(glyphIn(laidOut("a\\mathllap{12}"), '1').x, place - laidOut("12").width, rounding);
  EXPECT_NEAR(glyphIn(laidOut("a\\mathclap{12}"), '1').x, place - laidOut("12").width / 2, rounding);
}

TEST(Words, LettersThatTheMathFontLacks_AreTheTextFonts) {
  const Layout layout = laidOut("\\text{a длина}");
  ASSERT_EQ(layout.glyphs.size(), 7U);
  EXPECT_EQ(layout.glyphs[0].font, FontIndex::Math);
  for (std::size_t i = 2; i < layout.glyphs.size(); ++i) {
    EXPECT_EQ(layout.glyphs[i].font, FontIndex::Text);
    EXPECT_NE(layout.glyphs[i].glyph, 0U);
    EXPECT_GT(layout.glyphs[i].x, layout.glyphs[i - 1].x);
  }
}

TEST(Words, WithoutATextFont_MissingLettersAreGlyphZero) {
  const auto alone = readMathFonts(MATH_FONT);
  ASSERT_TRUE(alone);
  const Layout layout = layOut(parsed("\\text{ж}ж"), *alone);
  ASSERT_EQ(layout.glyphs.size(), 2U);
  EXPECT_EQ(layout.glyphs[0].glyph, 0U);
  EXPECT_EQ(layout.glyphs[1].glyph, 0U);
}

TEST(Boxed, TheFrame_GoesAroundItsContent) {
  const Layout layout = laidOut("\\boxed{x}");
  ASSERT_EQ(layout.rules.size(), 4U);
  const Rectangle ink = inkOf(letterIn(layout, 'x'));
  EXPECT_GT(ink.x, layout.rules[2].box.right());
  EXPECT_LT(ink.right(), layout.rules[3].box.x);
  EXPECT_GT(ink.y, layout.rules[0].box.bottom());
  EXPECT_LT(ink.bottom(), layout.rules[1].box.y);
}

} // namespace
} // namespace halfspace::math
