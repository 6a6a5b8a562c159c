#include "tests/formula/laid_out.h"

namespace halfspace::math {
namespace {

/// The middle of a letter's room.
double middleOf(const PlacedGlyph &glyph) {
  return glyph.x + fonts().math.face().metrics(glyph.glyph).advance * glyph.size / 2;
}

TEST(Tables, ColumnsOfAMatrix_AreCentred) {
  const Layout layout = laidOut("\\begin{matrix}1&abc\\\\222&3\\end{matrix}");
  EXPECT_NEAR(middleOf(glyphIn(layout, '1')), middleOf(glyphsOf(layout, '2')[1]), rounding);
  EXPECT_NEAR(middleOf(glyphIn(layout, '3')), middleOf(letterIn(layout, 'b')), 0.05);
}

TEST(Tables, Rows_ShareABaseline) {
  const Layout layout = laidOut("\\begin{matrix}1&\\frac 23\\\\4&5\\end{matrix}");
  EXPECT_NEAR(glyphIn(layout, '4').y, glyphIn(layout, '5').y, rounding);
  EXPECT_LT(glyphIn(layout, '1').y, glyphIn(layout, '4').y);
}

TEST(Tables, Columns_AreSetAsTheyAreAskedFor) {
  const Layout layout = laidOut("\\begin{array}{lr}1&2\\\\444&555\\end{array}");
  EXPECT_NEAR(glyphIn(layout, '1').x, glyphsOf(layout, '4')[0].x, rounding);
  EXPECT_NEAR(glyphIn(layout, '2').x, glyphsOf(layout, '5')[2].x, rounding);
}

TEST(Tables, RelationsOfAnAlignment_StandBelowEachOther) {
  const Layout layout = laidOut("\\begin{aligned}a+b&=c\\\\d&=e+f\\end{aligned}");
  const auto relations = glyphsOf(layout, '=');
  ASSERT_EQ(relations.size(), 2U);
  EXPECT_NEAR(relations[0].x, relations[1].x, rounding);
}

TEST(Tables, TheMiddle_IsOnTheAxis) {
  for (const char *source :
       {"\\begin{matrix}a\\\\b\\end{matrix}", "\\begin{aligned}a&=b\\\\c&=d\\\\e&=f\\end{aligned}",
        "\\begin{cases}a\\\\b\\end{cases}"}) {
    const Layout layout = laidOut(source);
    EXPECT_NEAR((layout.ascent - layout.depth) / 2, axisHeight(), 0.01) << source;
  }
}

TEST(Tables, TallRows_DoNotTouch) {
  const Layout layout = laidOut("\\begin{matrix}\\dfrac{1}{2}\\\\\\dfrac{3}{4}\\end{matrix}");
  EXPECT_GT(inkOf(glyphIn(layout, '3')).y - inkOf(glyphIn(layout, '2')).bottom(), 0.15);
}

TEST(Tables, RoomBelowARow_IsAdded) {
  const auto height = [](const char *source) {
    const Layout layout = laidOut(source);
    return layout.ascent + layout.depth;
  };
  EXPECT_NEAR(height("\\begin{matrix}a\\\\[1em]b\\end{matrix}") -
                  height("\\begin{matrix}a\\\\b\\end{matrix}"),
              1, rounding);
}

TEST(Tables, AColumnRule_StandsBetweenItsColumnsAndIsAsTallAsTheTable) {
  const Layout layout = laidOut("\\begin{array}{c|c}1&2\\\\3&4\\end{array}");
  ASSERT_EQ(layout.rules.size(), 1U);
  const Rectangle rule = layout.rules.front().box;
  EXPECT_GT(rule.x, inkOf(glyphIn(layout, '1')).right());
  EXPECT_LT(rule.right(), inkOf(glyphIn(layout, '2')).x);
  EXPECT_NEAR(rule.height, layout.ascent + layout.depth, rounding);
}

TEST(Tables, RulesAtTheEdges_EncloseTheEntries) {
  const Layout layout = laidOut("\\begin{array}{|c|}\\hline 1\\\\\\hline\\end{array}");
  ASSERT_EQ(layout.rules.size(), 4U);
  const Rectangle ink = inkOf(glyphIn(layout, '1'));
  EXPECT_GT(ink.x, layout.rules[0].box.right() + 0.2);
  EXPECT_LT(ink.right(), layout.rules[1].box.x - 0.2);
  EXPECT_GT(ink.y, layout.rules[2].box.bottom());
  EXPECT_LT(ink.bottom(), layout.rules[3].box.y);
}

TEST(Tables, ADoubleRule_IsTwo) {
  const Layout layout = laidOut("\\begin{array}{c||c}1&2\\end{array}");
  ASSERT_EQ(layout.rules.size(), 2U);
  EXPECT_GT(layout.rules[1].box.x, layout.rules[0].box.right() + 0.05);
}

TEST(Tables, ASmallMatrix_FitsIntoALine) {
  const Layout layout = laidOut("\\begin{smallmatrix}1&0\\\\0&1\\end{smallmatrix}");
  EXPECT_LT(layout.ascent + layout.depth, 1.7);
  EXPECT_NEAR(layout.glyphs.front().size, 0.7, 0.01);
}

TEST(Tables, AShorterRow_LeavesItsLastColumnsEmpty) {
  const Layout layout = laidOut("\\begin{matrix}1\\\\2&3\\end{matrix}");
  EXPECT_NEAR(glyphIn(layout, '1').x, glyphIn(layout, '2').x, rounding);
}

} // namespace
} // namespace halfspace::math
