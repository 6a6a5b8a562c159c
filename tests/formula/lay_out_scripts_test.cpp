// Scripts, limits, fractions and roots: how they stand to each other, whatever the font's numbers are.
#include "tests/formula/laid_out.h"

namespace halfspace::math {
namespace {

double heightOf(const std::string &latex, Style style = Style::Display) {
  const Layout layout = laidOut(latex, style);
  return layout.ascent + layout.depth;
}

/// How high above the baseline a letter stands.
double raised(const std::string &latex, char32_t letter) { return -letterIn(laidOut(latex), letter).y; }

TEST(Superscripts, InCrampedPlaces_RiseLess) {
  EXPECT_LT(raised("\\sqrt{x^n}", 'n'), raised("x^n", 'n'));
  EXPECT_LT(raised("\\overline{x^n}", 'n'), raised("x^n", 'n'));
  const Layout fraction = laidOut("\\frac{x^n}{y^m}");
  const double above = letterIn(fraction, 'x').y - letterIn(fraction, 'n').y;
  const double below = letterIn(fraction, 'y').y - letterIn(fraction, 'm').y;
  EXPECT_LT(below, above) << "a denominator is cramped";
}

TEST(Superscripts, OnASlantedLetter_StandFartherRightThanSubscripts) {
  const Layout layout = laidOut("f^a_b");
  EXPECT_GT(letterIn(layout, 'a').x, letterIn(layout, 'b').x);
  const Layout upright = laidOut("\\mathrm{H}^a_b");
  EXPECT_NEAR(letterIn(upright, 'a').x, letterIn(upright, 'b').x, 0.05);
}

TEST(Superscripts, WithDescenders_StayClearOfTheBaseline) {
  for (const char *script : {"g", "\\frac gy", "\\begin{matrix}1\\\\2\\\\3\\end{matrix}"}) {
    const Layout layout = laidOut("x^{" + std::string(script) + "}");
    for (std::size_t i = 1; i < layout.glyphs.size(); ++i)
      EXPECT_LT(inkOf(layout.glyphs[i]).bottom(), 0) << script;
  }
}

TEST(Subscripts, ThatAreTall_HangLower) {
  const auto top = [](const std::string &latex) {
    const Layout layout = laidOut(latex);
    double highest = 1e9;
    for (std::size_t i = 1; i < layout.glyphs.size(); ++i)
      highest = std::min(highest, inkOf(layout.glyphs[i]).y);
    return highest;
  };
  EXPECT_GT(top("x_{\\frac{a}{b}}"), -0.45) << "below the letter's upper half";
  EXPECT_GT(laidOut("x_{\\frac{a}{b}}").depth, laidOut("x_a").depth);
}

TEST(Scripts, BothTall_AreMovedApart) {
  const Layout layout = laidOut("x^{\\frac{a}{b}}_{\\frac{c}{d}}");
  const double bottomOfUpper = inkOf(letterIn(layout, 'b')).bottom();
  const double topOfLower = inkOf(letterIn(layout, 'c')).y;
  EXPECT_GT(topOfLower - bottomOfUpper, 0.1);
}

TEST(Scripts, OnNothing_StandAsOnALowLetter) {
  const Layout layout = laidOut("{}^a_b");
  EXPECT_LT(letterIn(layout, 'a').y, 0);
  EXPECT_GT(letterIn(layout, 'b').y, 0);
  EXPECT_NEAR(letterIn(layout, 'a').x, letterIn(layout, 'b').x, 0.01);
}

TEST(Scripts, OfATall_StandAtItsCorners) {
  const Layout layout = laidOut("\\begin{pmatrix}1\\\\2\\\\3\\end{pmatrix}^a_b");
  const Layout base = laidOut("\\begin{pmatrix}1\\\\2\\\\3\\end{pmatrix}");
  EXPECT_LT(letterIn(layout, 'a').y, -base.ascent + 0.6);
  EXPECT_GT(letterIn(layout, 'b').y, base.depth - 0.6);
  EXPECT_GE(letterIn(layout, 'a').x, base.width - 0.1);
}

TEST(Scripts, LeaveRoomBehindThem) {
  const Layout layout = laidOut("x^ab");
  EXPECT_GT(letterIn(layout, 'b').x, inkOf(letterIn(layout, 'a')).right());
}

TEST(Limits, AboveAndBelow_KeepTheirDistanceFromTheOperator) {
  const Layout layout = laidOut("\\sum_a^g");
  const Rectangle sum = inkOf(layout.glyphs.front());
  EXPECT_GT(inkOf(letterIn(layout, 'a')).y - sum.bottom(), 0.1);
  EXPECT_GT(sum.y - inkOf(letterIn(layout, 'g')).bottom(), 0.1);
}

TEST(Limits, ThatAreTall_StayClearToo) {
  const Layout layout = laidOut("\\sum_{\\begin{matrix}a\\\\b\\\\d\\end{matrix}}^{\\frac cg}");
  const Rectangle sum = inkOf(layout.glyphs.front());
  EXPECT_GT(inkOf(letterIn(layout, 'a')).y - sum.bottom(), 0.05);
  EXPECT_GT(sum.y - inkOf(letterIn(layout, 'g')).bottom(), 0.05);
}

TEST(Limits, OfWords_AreWrittenBelowThem) {
  const Layout layout = laidOut("\\lim_{n\\to\\infty}a");
  EXPECT_GT(letterIn(layout, 'n').y, 0.3);
  EXPECT_LT(letterIn(layout, 'n').x, 1.5);
  const Layout beside = laidOut("\\cos_n a");
  EXPECT_LT(letterIn(beside, 'n').y, 0.3);
}

TEST(Fractions, InsideFractions_AreSmallerUpToALimit) {
  std::vector<double> sizes;
  const Layout layout = laidOut("\\frac{1}{\\frac{2}{\\frac{3}{\\frac{4}{5}}}}");
  for (const char32_t digit : {U'1', U'2', U'3', U'4', U'5'})
    sizes.push_back(glyphIn(layout, digit).size);
  EXPECT_EQ(sizes[0], 1);
  EXPECT_TRUE(std::is_sorted(sizes.rbegin(), sizes.rend()));
  EXPECT_LT(sizes[2], 0.6);
  EXPECT_EQ(sizes[3], sizes[2]) << "and then no smaller";
}

TEST(Fractions, OfTallParts_KeepThemOffTheirBar) {
  const Layout layout = laidOut("\\frac{\\frac{a}{g}}{\\frac{b}{c}}");
  ASSERT_EQ(layout.rules.size(), 3U);
  const Rectangle bar = layout.rules.back().box; // its parts were set before it
  EXPECT_NEAR(bar.y + bar.height / 2, -axisHeight(), rounding);
  EXPECT_GT(bar.y - inkOf(letterIn(layout, 'g')).bottom(), 0.05);
  EXPECT_GT(inkOf(letterIn(layout, 'b')).y - bar.bottom(), 0.05);
}

TEST(Binomials, HaveNoBarAndDoNotTouch) {
  const Layout layout = laidOut("\\binom{g}{h}");
  EXPECT_TRUE(layout.rules.empty());
  EXPECT_GT(inkOf(letterIn(layout, 'h')).y - inkOf(letterIn(layout, 'g')).bottom(), 0.1);
  const Layout tall = laidOut("\\binom{\\frac ag}{\\frac bc}");
  EXPECT_GT(inkOf(letterIn(tall, 'b')).y - inkOf(letterIn(tall, 'g')).bottom(), 0.1);
}

TEST(Roots, OfSmallAndTallLetters_HaveTheirBarAboveThemAll) {
  for (const char *radicand : {"x", "h", "x^2", "\\vec B", "\\frac{a}{b}"}) {
    const Layout root = laidOut("\\sqrt{" + std::string(radicand) + "}");
    const Layout inside = laidOut(radicand);
    const double barBottom = root.rules.back().box.bottom();
    EXPECT_GT(-barBottom - inside.ascent, 0) << radicand;
    EXPECT_LE(-root.rules.back().box.y, root.ascent + rounding) << radicand;
    double signBottom = -1;
    for (std::size_t i = inside.glyphs.size(); i < root.glyphs.size(); ++i)
      signBottom = std::max(signBottom, inkOf(root.glyphs[i]).bottom());
    EXPECT_GE(signBottom, inside.depth - rounding) << radicand << ": the sign goes down to its foot";
  }
}

TEST(Roots, WithADegree_AreWiderOnlyByWhatStandsOut) {
  const double plain = laidOut("\\sqrt{x}").width;
  EXPECT_LT(laidOut("\\sqrt[3]{x}").width - plain, 0.35);
  EXPECT_GT(laidOut("\\sqrt[abcdef]{x}").width - plain, 1);
  EXPECT_LT(heightOf("\\sqrt[3]{x}"), 1.4 * heightOf("\\sqrt{x}"));
}

TEST(Formulas, InText_AreNoTallerThanDisplayed) {
  for (const char *latex : {"\\frac{a}{b}", "\\sum_i^n x_i", "\\binom nk", "\\sqrt{x}", "x^2_1", "\\int_0^1",
                            "\\left(\\frac ab\\right)"})
    EXPECT_LE(heightOf(latex, Style::Text), heightOf(latex) + rounding) << latex;
}

} // namespace
} // namespace halfspace::math
