// Accents, bars, braces, arrows and strokes: what grows over and under a base.
#include "tests/formula/laid_out.h"

namespace halfspace::math {
namespace {

double heightOf(const Layout &layout) { return layout.ascent + layout.depth; }

/// The only rule of a formula.
Rectangle ruleOf(const Layout &layout) {
  EXPECT_EQ(layout.rules.size(), 1U);
  return layout.rules.empty() ? Rectangle() : layout.rules.front().box;
}

/// The ink of all glyphs behind the first so many together.
Rectangle inkBehind(const Layout &layout, std::size_t first) {
  Rectangle all = inkOf(layout.glyphs.at(first));
  for (std::size_t i = first + 1; i < layout.glyphs.size(); ++i) {
    const Rectangle ink = inkOf(layout.glyphs[i]);
    const double right = std::max(all.right(), ink.right());
    const double bottom = std::max(all.bottom(), ink.bottom());
    all.x = std::min(all.x, ink.x);
    all.y = std::min(all.y, ink.y);
    all.width = right - all.x;
    all.height = bottom - all.y;
  }
  return all;
}

TEST(Bars, OverAndUnder_AreAsWideAsTheirBaseAndClearOfIt) {
  const double width = laidOut("abg").width;
  const Layout over = laidOut("\\overline{abg}");
  EXPECT_NEAR(ruleOf(over).width, width, rounding);
  EXPECT_LT(ruleOf(over).bottom(), inkOf(letterIn(over, 'b')).y);
  const Layout under = laidOut("\\underline{abg}");
  EXPECT_NEAR(ruleOf(under).width, width, rounding);
  EXPECT_GT(ruleOf(under).y, inkOf(letterIn(under, 'g')).bottom());
}

TEST(Bars, UnderLettersWithoutDescenders_StayBelowTheBaseline) {
  EXPECT_GT(ruleOf(laidOut("\\underline{=}")).y, 0);
  EXPECT_GT(ruleOf(laidOut("\\underline{x}")).y, 0);
  EXPECT_LT(ruleOf(laidOut("\\underline{x}")).y, ruleOf(laidOut("\\underline{g}")).y);
}

TEST(Bars, TheOneOverTheOther_AreBothSeen) {
  const Layout layout = laidOut("\\overline{\\overline{x}}");
  ASSERT_EQ(layout.rules.size(), 2U);
  EXPECT_LT(layout.rules[1].box.bottom(), layout.rules[0].box.y);
}

TEST(Accents, OverACapital_StandAsFarAboveItAsOverASmallLetter) {
  const auto gapAbove = [](const std::string &source) {
    const Layout layout = laidOut(source);
    return inkOf(layout.glyphs[0]).y - inkOf(layout.glyphs[1]).bottom();
  };
  for (const char *accent : {"\\hat ", "\\bar ", "\\dot "}) {
    EXPECT_NEAR(gapAbove(std::string(accent) + "x"), gapAbove(std::string(accent) + "H"), 0.06) << accent;
    EXPECT_GT(gapAbove(std::string(accent) + "H"), 0) << accent;
  }
}

TEST(Accents, OverALeaningLetter_LeanWithIt) {
  const auto middle = [](const std::string &source) {
    const Rectangle ink = inkOf(laidOut(source).glyphs[1]);
    return ink.x + ink.width / 2;
  };
  const Rectangle letter = inkOf(laidOut("\\hat f").glyphs[0]);
  EXPECT_GT(middle("\\hat f"), letter.x + letter.width / 2);
}

TEST(Accents, ThatAreWide_GrowWithTheirBaseAndSimpleOnesDoNot) {
  const auto width = [](const std::string &source) { return inkOf(laidOut(source).glyphs.back()).width; };
  EXPECT_GT(width("\\widehat{xyz}"), 1.3 * width("\\widehat{x}"));
  EXPECT_NEAR(width("\\hat{xyz}"), width("\\hat{x}"), rounding);
  EXPECT_LE(width("\\widehat{xyz}"), laidOut("xyz").width + rounding);
}

TEST(Accents, InScripts_AreAsSmallAsTheirLetters) {
  const Layout layout = laidOut("a^{\\vec n}");
  EXPECT_EQ(layout.glyphs.back().size, letterIn(layout, 'n').size);
  EXPECT_LT(layout.glyphs.back().size, 1);
}

TEST(Braces, OnBothSides_StandClearOfWhatTheyHold) {
  const Layout over = laidOut("\\overbrace{abcdef}");
  EXPECT_LT(inkBehind(over, 6).bottom(), inkOf(letterIn(over, 'b')).y);
  EXPECT_GE(inkBehind(over, 6).width, laidOut("abcdef").width - 0.1);
  EXPECT_LT(inkBehind(over, 6).width, laidOut("abcdef").width + 1);
  const Layout under = laidOut("\\underbrace{abcdef}");
  EXPECT_GT(inkBehind(under, 6).y, inkOf(letterIn(under, 'f')).bottom());
}

TEST(Braces, OverOneLetter_LeaveItInTheirMiddle) {
  const Layout layout = laidOut("\\underbrace{i}");
  const Rectangle letter = inkOf(layout.glyphs.front());
  const Rectangle brace = inkBehind(layout, 1);
  EXPECT_GT(brace.width, letter.width);
  EXPECT_NEAR(letter.x + letter.width / 2, brace.x + brace.width / 2, 0.04);
  EXPECT_NEAR(layout.width, brace.width, 0.2);
}

TEST(Arrows, WithWordsAboveAndBelow_HaveThemInTheirMiddle) {
  const Layout layout = laidOut("\\xrightarrow[b]{a+c}");
  const PlacedGlyph above = glyphIn(layout, '+');
  const PlacedGlyph below = letterIn(layout, 'b');
  EXPECT_LT(above.y, 0);
  EXPECT_GT(below.y, 0);
  for (const PlacedGlyph &glyph : {above, below})
    EXPECT_NEAR(inkOf(glyph).x + inkOf(glyph).width / 2, layout.width / 2, 0.1);
  EXPECT_LT(above.size, 1);
}

TEST(Arrows, HoweverLong_StandAtTheSameHeight) {
  const auto height = [](const std::string &words) {
    const Layout layout = laidOut("\\xrightarrow{\\phantom{" + words + "}}");
    return inkBehind(layout, 0).y;
  };
  EXPECT_NEAR(height("a"), height("abcdefghijklmnop"), 0.05);
}

TEST(Strokes, ThroughWhatHasNoOther_StandInItsMiddle) {
  const Layout layout = laidOut("\\not\\perp");
  ASSERT_EQ(layout.glyphs.size(), 2U);
  const Rectangle base = inkOf(layout.glyphs[0]);
  const Rectangle slash = inkOf(layout.glyphs[1]);
  EXPECT_NEAR(slash.x + slash.width / 2, base.x + base.width / 2, 0.1);
  EXPECT_NEAR(slash.y + slash.height / 2, base.y + base.height / 2, 0.1);
  EXPECT_NEAR(layout.width, laidOut("\\perp").width, rounding);
}

TEST(Stacks, OverARelation_LeaveItWhereItStands) {
  const Layout layout = laidOut("a\\overset{n}{=}b");
  EXPECT_EQ(glyphIn(layout, '=').y, 0);
  const PlacedGlyph small = letterIn(layout, 'n');
  EXPECT_LT(inkOf(small).bottom(), inkOf(glyphIn(layout, '=')).y);
  EXPECT_LT(small.size, 1);
  const Layout below = laidOut("a\\underset{n}{=}b");
  EXPECT_GT(inkOf(letterIn(below, 'n')).y, inkOf(glyphIn(below, '=')).bottom());
}

TEST(Tables, OfSeveralPairs_SetEachRelationBelowTheOthers) {
  const Layout layout = laidOut("\\begin{aligned}a&=b&c&=d\\\\aaa&=b&ccc&=d\\end{aligned}");
  const auto relations = glyphsOf(layout, '=');
  ASSERT_EQ(relations.size(), 4U);
  EXPECT_NEAR(relations[0].x, relations[2].x, rounding);
  EXPECT_NEAR(relations[1].x, relations[3].x, rounding);
  EXPECT_GT(relations[1].x - relations[0].x, 2) << "the pairs stand apart";
  EXPECT_LT(relations[0].x - glyphsOf(layout, inAlphabet('a', Alphabet::Italic))[0].x, 1) << "and no halves";
  const auto cs = glyphsOf(layout, inAlphabet('c', Alphabet::Italic));
  EXPECT_NEAR(cs[0].x, cs.back().x, rounding) << "what stands before a relation ends at it";
}

TEST(Tables, InScripts_AreAsSmall) {
  EXPECT_LT(heightOf(laidOut("x^{\\begin{matrix}1\\\\2\\end{matrix}}")),
            heightOf(laidOut("\\begin{matrix}1\\\\2\\end{matrix}")));
  EXPECT_LT(glyphIn(laidOut("x^{\\begin{matrix}1\\\\2\\end{matrix}}"), '1').size, 1);
}

TEST(Tables, WithADoubleRuleBelow_AreAsWideAsIt) {
  const Layout layout = laidOut("\\begin{array}{cc}1&2\\\\\\hline\\hline\\end{array}");
  ASSERT_EQ(layout.rules.size(), 2U);
  EXPECT_LT(layout.rules[0].box.bottom(), layout.rules[1].box.y);
  for (const Rule &rule : layout.rules) {
    EXPECT_NEAR(rule.box.width, layout.width, rounding);
    EXPECT_GT(rule.box.y, inkOf(glyphIn(layout, '1')).bottom());
  }
}

TEST(Tables, WithoutCells_HaveNoInk) {
  const Layout layout = laidOut("a\\begin{matrix}\\end{matrix}");
  EXPECT_EQ(layout.glyphs.size(), 1U);
  EXPECT_LT(layout.width, laidOut("a").width + 1);
}

TEST(LargeOperators, WithLimitsOfAnyWidth_HaveThemInTheMiddle) {
  const Layout layout = laidOut("\\sum_{a+b+c+d}^{n}");
  const Rectangle above = inkOf(letterIn(layout, 'n'));
  EXPECT_NEAR(above.x + above.width / 2, layout.width / 2, 0.15);
  EXPECT_GT(letterIn(layout, 'a').x, -rounding) << "nothing stands out to the left";
}

TEST(Roots, OfTallRadicands_GrowAndKeepTheirBarClear) {
  double last = 0;
  for (const char *radicand : {"x", "\\frac ab", "\\frac{\\frac ab}{\\frac cd}"}) {
    const Layout layout = laidOut("\\sqrt{" + std::string(radicand) + "}");
    EXPECT_GT(heightOf(layout), last);
    EXPECT_GT(heightOf(layout), heightOf(laidOut(radicand)));
    last = heightOf(layout);
  }
}

} // namespace
} // namespace halfspace::math
