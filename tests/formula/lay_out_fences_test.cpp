// Fences: as tall as what they hold, whatever character they are and wherever they stand.
#include "tests/formula/laid_out.h"

namespace halfspace::math {
namespace {

double heightOf(const Layout &layout) { return layout.ascent + layout.depth; }

/// Rows of single letters, as tall as they are many.
std::string rowsOf(int count) {
  std::string rows = "a";
  for (int i = 1; i < count; ++i)
    rows += "\\\\a";
  return "\\begin{matrix}" + rows + "\\end{matrix}";
}

/// What a fence of a formula that holds only phantoms takes, from its highest to its lowest ink.
std::pair<double, double> spanOf(const Layout &layout) {
  double top = 1e9;
  double bottom = -1e9;
  for (const PlacedGlyph &glyph : layout.glyphs) {
    top = std::min(top, inkOf(glyph).y);
    bottom = std::max(bottom, inkOf(glyph).bottom());
  }
  for (const Rule &rule : layout.rules) {
    top = std::min(top, rule.box.y);
    bottom = std::max(bottom, rule.box.bottom());
  }
  return {top, bottom};
}

struct GrowingFences : testing::TestWithParam<const char *> {
  [[nodiscard]] static Layout around(int rows) {
    return laidOut("\\left" + std::string(GetParam()) + "\\phantom{" + rowsOf(rows) + "}\\right.");
  }
};

TEST_P(GrowingFences, AroundMoreAndMore_GrowsWithItOnTheAxis) {
  double last = 0;
  for (const int rows : {1, 2, 3, 5, 9, 15}) {
    const auto [top, bottom] = spanOf(around(rows));
    EXPECT_GE(bottom - top, 0.9 * heightOf(laidOut(rowsOf(rows))) - 0.15) << rows;
    EXPECT_GE(bottom - top, last - rounding) << rows;
    EXPECT_NEAR((top + bottom) / 2, -axisHeight(), 0.03) << rows;
    last = bottom - top;
  }
}

TEST_P(GrowingFences, AroundMoreAndMore_StaysNarrow) {
  for (const int rows : {1, 5, 15}) {
    const double inside = laidOut("\\phantom{" + rowsOf(rows) + "}").width;
    EXPECT_LT(around(rows).width - inside, 1.3) << rows;
  }
}

TEST_P(GrowingFences, AroundTallContent_ReachAsFarAsItDoes) {
  constexpr double hair = 0.05;
  for (const char *content : {"\\frac{a}{b}", "\\frac{\\frac{a}{b}}{c}", "\\frac{a}{\\frac{b}{\\frac{c}{d}}}",
                              "\\sqrt{\\frac{x^2}{y}}", "\\tfrac{1}{2}"}) {
    const Layout inside = laidOut(content);
    const std::string name = GetParam();
    const auto [top, bottom] =
        spanOf(laidOut("\\left" + name + "\\phantom{" + std::string(content) + "}\\right."));
    EXPECT_LE(top, -inside.ascent + hair) << name << content;
    EXPECT_GE(bottom, inside.depth - hair) << name << content;
  }
}

INSTANTIATE_TEST_SUITE_P(Characters, GrowingFences,
                         testing::Values("(", "[", "\\{", "|", "\\|", "\\lfloor", "\\rceil", "\\lceil"));

TEST(Fences, OfOnePair_AreAsTallAsEachOther) {
  const Layout layout = laidOut("\\left(\\phantom{\\frac ab}\\right)");
  ASSERT_EQ(layout.glyphs.size(), 2U);
  EXPECT_NEAR(inkOf(layout.glyphs[0]).y, inkOf(layout.glyphs[1]).y, rounding);
  EXPECT_NEAR(inkOf(layout.glyphs[0]).height, inkOf(layout.glyphs[1]).height, rounding);
}

TEST(Fences, ThatAreLeftOut_TakeALittleRoom) {
  const double room = laidOut("\\left.x\\right.").width - laidOut("x").width;
  EXPECT_NEAR(room, 2 * 0.12, rounding);
  EXPECT_EQ(laidOut("\\left.x\\right.").glyphs.size(), 1U);
}

TEST(Fences, InsideFences_AreNoTallerThanThoseAround) {
  const Layout layout = laidOut("\\left(\\left(\\left(\\phantom{\\frac ab}\\right)\\right)\\right)");
  ASSERT_EQ(layout.glyphs.size(), 6U);
  for (const PlacedGlyph &glyph : layout.glyphs)
    EXPECT_LE(inkOf(glyph).height, heightOf(layout) + rounding);
  EXPECT_LT(heightOf(layout), 1.3 * heightOf(laidOut("\\left(\\frac ab\\right)")));
}

TEST(Fences, AroundWhatHangsLow_ReachAsFarUpAsDown) {
  const auto [top, bottom] = spanOf(laidOut("\\left(\\phantom{x_{\\frac{a}{\\frac bc}}}\\right)"));
  EXPECT_NEAR((top + bottom) / 2, -axisHeight(), 0.03);
  EXPECT_GT(bottom, 0.7 * laidOut("x_{\\frac{a}{\\frac bc}}").depth);
}

TEST(Fences, InScripts_AreAsSmallAsTheirLetters) {
  const Layout layout = laidOut("x^{\\left(n\\right)}");
  for (const PlacedGlyph &glyph : layout.glyphs)
    if (glyph.glyph != letterIn(layout, 'x').glyph) {
      EXPECT_LT(glyph.size, 1);
    }
}

TEST(Fences, GivenTheirSize_KeepItWhateverTheyHold) {
  const auto height = [](const std::string &latex) {
    const auto [top, bottom] = spanOf(laidOut(latex));
    return bottom - top;
  };
  EXPECT_NEAR(height("\\bigl(\\phantom{x}\\bigr)"), height("\\bigl(\\phantom{\\frac ab}\\bigr)"), rounding);
  EXPECT_GT(height("\\Bigl\\{"), height("\\bigl\\{"));
}

TEST(Fences, GivenAsOpeningOrRelation_StandAsFarApartAsThose) {
  const double none = laidOut("0").width + laidOut("1").width;
  const double fence = laidOut("\\big|").width;
  EXPECT_NEAR(laidOut("0\\bigl|1").width, none + fence, rounding);
  EXPECT_NEAR(laidOut("0\\bigm|1").width, none + fence + 2 * 5.0 / 18, rounding);
}

TEST(Fences, PutTogetherFromParts_HaveNoGapsInTheirInk) {
  for (const char *fence : {"(", "[", "\\{"}) {
    const Layout layout = laidOut("\\left" + std::string(fence) + "\\phantom{" + rowsOf(15) + "}\\right.");
    std::vector<Rectangle> inks;
    for (const PlacedGlyph &glyph : layout.glyphs)
      inks.push_back(inkOf(glyph));
    ASSERT_GT(inks.size(), 2U) << fence;
    std::sort(inks.begin(), inks.end(), [](const Rectangle &a, const Rectangle &b) { return a.y < b.y; });
    for (std::size_t i = 1; i < inks.size(); ++i)
      EXPECT_LE(inks[i].y, inks[i - 1].bottom() + 0.002) << fence;
  }
}

} // namespace
} // namespace halfspace::math
