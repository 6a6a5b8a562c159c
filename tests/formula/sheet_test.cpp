// The sheet that formulas are set on: boxes that are put, moved and taken away.
#include "widgets/formula/sheet.h"

#include "tests/formula/laid_out.h"

namespace halfspace::math {
namespace {

constexpr SetStyle display{Style::Display, false};

/// A sheet with one box of a glyph and a rule on it.
struct WrittenSheet : testing::Test {
  Sheet sheet{fonts()};

  Box boxOfGlyph(double width = 2) {
    Box box = sheet.begin();
    sheet.putGlyph(FontIndex::Math, 7, 0, 0, display);
    sheet.putRule(0, 1, width, 0.5);
    box.width = width;
    box.ascent = 1;
    box.depth = 0.25;
    sheet.close(box);
    return box;
  }
  const Rule &rule(std::size_t index) { return sheet.layout().rules.at(index); }
  const PlacedGlyph &glyph(std::size_t index) { return sheet.layout().glyphs.at(index); }
};

TEST_F(WrittenSheet, ABoxThatIsMoved_TakesItsShapesAlongAndNoOthers) {
  (void)boxOfGlyph();
  const Box second = boxOfGlyph();
  sheet.move(second, 3, 0.5);
  EXPECT_EQ(glyph(0).x, 0);
  EXPECT_EQ(glyph(1).x, 3);
  EXPECT_EQ(glyph(1).y, -0.5) << "y points down on the page";
  EXPECT_EQ(rule(0).box.y, -1);
  EXPECT_EQ(rule(1).box.y, -1.5);
}

TEST_F(WrittenSheet, ABoxThatIsPlaced_IsReachedAroundByTheOther) {
  Box all = sheet.begin();
  sheet.place(all, boxOfGlyph(), 1, 0.75);
  EXPECT_EQ(all.width, 3);
  EXPECT_EQ(all.ascent, 1.75);
  EXPECT_EQ(all.depth, 0) << "it stands above the baseline now";
  sheet.place(all, boxOfGlyph(1), 0, -0.5);
  EXPECT_EQ(all.width, 3) << "the narrower one changes nothing";
  EXPECT_EQ(all.depth, 0.75);
  sheet.move(all, 10, 0);
  EXPECT_EQ(glyph(0).x, 11);
  EXPECT_EQ(glyph(1).x, 10);
}

TEST_F(WrittenSheet, ABoxWithASlant_IsPlacedWithItsFullWidth) {
  Box slanted = boxOfGlyph();
  slanted.italics = 0.1;
  Box all = sheet.begin();
  sheet.place(all, slanted, 1, 0);
  EXPECT_DOUBLE_EQ(all.width, 3.1);
  EXPECT_DOUBLE_EQ(slanted.fullWidth(), 2.1);
  EXPECT_DOUBLE_EQ(slanted.height(), 1.25);
}

TEST_F(WrittenSheet, WhatIsForgotten_IsGoneFromTheSheet) {
  (void)boxOfGlyph();
  const Box second = boxOfGlyph();
  sheet.forget(second);
  EXPECT_EQ(sheet.layout().glyphs.size(), 1U);
  EXPECT_EQ(sheet.layout().rules.size(), 1U);
}

TEST_F(WrittenSheet, TagsInsideTags_KnowTheirParentsAndTheirShapes) {
  const std::size_t outer = sheet.openTag("a");
  const Ink ofOuter = sheet.ink();
  (void)sheet.openTag("b");
  (void)boxOfGlyph();
  sheet.setInk(ofOuter);
  (void)boxOfGlyph();
  sheet.setTagBox(outer, {1, 2, 3, 4});
  const Layout &layout = sheet.layout();
  ASSERT_EQ(layout.tags.size(), 2U);
  EXPECT_EQ(layout.tags[0].parent, noTag);
  EXPECT_EQ(layout.tags[1].parent, 0);
  EXPECT_EQ(layout.glyphs[0].ink.tag, 1);
  EXPECT_EQ(layout.glyphs[1].ink.tag, 0);
  EXPECT_EQ(layout.tagBoxes[0].box.right(), 4);
}

TEST_F(WrittenSheet, Depth_IsCountedUpToTheLimitAndBack) {
  int deep = 0;
  while (deep < 100000 && sheet.descend())
    ++deep;
  EXPECT_EQ(deep, deepestLayout);
  sheet.ascend();
  EXPECT_TRUE(sheet.descend());
  EXPECT_FALSE(sheet.descend());
}

TEST_F(WrittenSheet, ScriptsAndTheirScripts_AreSmallerByTheFontsMeasure) {
  EXPECT_EQ(sheet.em({Style::Text}), 1);
  EXPECT_NEAR(sheet.em({Style::Script}), 0.7, 0.01);
  EXPECT_NEAR(sheet.em({Style::ScriptScript}), 0.5, 0.01);
  EXPECT_NEAR(sheet.axis({Style::Script}), 0.7 * sheet.axis(display), 0.01);
}

/// The sizes that a path of styles goes through: s a superscript, b a subscript, n a numerator, d a
/// denominator.
std::string sizesAlong(std::string_view path, SetStyle style = display) {
  std::string sizes;
  for (const char step : path) {
    style = step == 's'   ? style.superscript()
            : step == 'b' ? style.subscript()
            : step == 'n' ? style.numerator()
                          : style.denominator();
    sizes += std::to_string(static_cast<int>(style.size)) + (style.isCramped ? "'" : "");
  }
  return sizes;
}

TEST(SetStyle, OfScriptsAndFractions_GoesThroughTexsEight) {
  EXPECT_EQ(sizesAlong("sss"), "233");
  EXPECT_EQ(sizesAlong("bs"), "2'3'");
  EXPECT_EQ(sizesAlong("nnnn"), "1233");
  EXPECT_EQ(sizesAlong("dn"), "1'2'") << "what is cramped stays so";
  EXPECT_EQ(sizesAlong("s", {Style::Text, true}), "2'");
  EXPECT_EQ(SetStyle({Style::Display, true}).sized(Style::Script).isCramped, true);
}

} // namespace
} // namespace halfspace::math
