#include "tests/formula/laid_out.h"

namespace halfspace::math {
namespace {

constexpr double mu = 1.0 / 18;
constexpr double thin = 3 * mu;
constexpr double medium = 4 * mu;
constexpr double thick = 5 * mu;

/// The space on the left and right of one character between `a` and `1`, which lean neither way.
std::pair<double, double> around(std::string_view latex, char32_t character) {
  const Layout layout = laidOut(latex);
  const PlacedGlyph middle = glyphIn(layout, character);
  return {gapBetween(glyphIn(layout, '0'), middle), gapBetween(middle, glyphIn(layout, '1'))};
}

TEST(Spacing, AroundAnOperation_IsMedium) {
  const auto [left, right] = around("0+1", '+');
  EXPECT_NEAR(left, medium, rounding);
  EXPECT_NEAR(right, medium, rounding);
}

TEST(Spacing, AroundARelation_IsThick) {
  const auto [left, right] = around("0=1", '=');
  EXPECT_NEAR(left, thick, rounding);
  EXPECT_NEAR(right, thick, rounding);
}

TEST(Spacing, BehindAComma_IsThin) {
  const auto [left, right] = around("0,1", ',');
  EXPECT_NEAR(left, 0, rounding);
  EXPECT_NEAR(right, thin, rounding);
}

TEST(Spacing, ASignWithNothingToCombine_StandsClose) {
  for (const char *source :
       {"-1", "(-1", "=-1", "x\\cdot-1", ",-1", "{}=-1", "\\mark{a}{-1}", "=\\mark{a}{-1}",
        "\\left(-1\\right)", "\\frac{-1}{x}", "x^{-1}", "\\begin{matrix}-1\\end{matrix}"}) {
    const Layout layout = laidOut(source);
    EXPECT_NEAR(gapBetween(glyphIn(layout, U'−'), glyphIn(layout, '1')), 0, rounding) << source;
  }
}

TEST(Spacing, ASignThatCombines_StandsOff) {
  for (const char *source : {"x-1", ")-1", "x!-1", "\\mark{a}{x-1}", "x\\mark{a}{-1}", "\\mark{a}{x}-1",
                             "\\color{red}{x}\\color{blue}{-}1", "x^2-1", "{}-1"}) {
    const Layout layout = laidOut(source);
    EXPECT_NEAR(gapBetween(glyphIn(layout, U'−'), glyphIn(layout, '1')), medium, rounding) << source;
  }
}

TEST(Spacing, ASignBehindAnOpeningBar_StandsClose) {
  for (const char *source : {"|-1|", "x=|-1|", "|x||-1|", "2\\cdot\\|-1\\|", "||-1||", "\\big|-1\\big|"}) {
    const Layout layout = laidOut(source);
    EXPECT_NEAR(gapBetween(glyphIn(layout, U'−'), glyphIn(layout, '1')), 0, rounding) << source;
  }
}

TEST(Spacing, ASignBehindAClosingBar_StandsOff) {
  for (const char *source : {"|x|-1", "||x||-1", "\\|x\\|-1", "f|_0-1", "(x|y)-1", "|a+b|-1"}) {
    const Layout layout = laidOut(source);
    EXPECT_NEAR(gapBetween(glyphIn(layout, U'−'), glyphIn(layout, '1')), medium, rounding) << source;
  }
}

TEST(Spacing, ASignAtTheEnd_StandsClose) {
  const Layout layout = laidOut("0+");
  EXPECT_NEAR(gapBetween(glyphIn(layout, '0'), glyphIn(layout, '+')), 0, rounding);
  const Layout before = laidOut("0+=1");
  EXPECT_NEAR(gapBetween(glyphIn(before, '0'), glyphIn(before, '+')), 0, rounding);
}

TEST(Spacing, InScripts_OperationsStandClose) {
  const Layout layout = laidOut("x^{0+1}");
  EXPECT_NEAR(gapBetween(glyphIn(layout, '0'), glyphIn(layout, '+')), 0, rounding);
}

TEST(Spacing, TagsAndColours_ChangeNothing) {
  const double plain = laidOut("a+b=-c").width;
  for (const char *source : {"\\mark{x}{a+b=-c}", "a\\mark{x}{+b}=-c", "a\\mark{x}{+}b\\color{red}{=}-c",
                             "\\mark{x}{a+}\\mark{y}{b=-}c", "a+b=\\mark{x}{\\mark{y}{-}c}"})
    EXPECT_NEAR(laidOut(source).width, plain, rounding) << source;
}

TEST(Spacing, BracesAroundARelation_TakeItsSpace) {
  EXPECT_NEAR(laidOut("0=1").width - laidOut("0{=}1").width, 2 * thick, rounding);
}

TEST(Spacing, BehindAnAlignment_ARelationStandsOff) {
  const Layout layout = laidOut("\\begin{aligned}0&=1\\end{aligned}");
  EXPECT_NEAR(gapBetween(glyphIn(layout, '0'), glyphIn(layout, '=')), thick, rounding);
}

TEST(Spacing, GivenSpaces_AreAsWideAsTheySay) {
  const double none = laidOut("01").width;
  EXPECT_NEAR(laidOut("0\\,1").width - none, thin, rounding);
  EXPECT_NEAR(laidOut("0\\quad 1").width - none, 1, rounding);
  EXPECT_NEAR(laidOut("0\\!1").width - none, -thin, rounding);
  EXPECT_NEAR(laidOut("0\\hspace{2.5em}1").width - none, 2.5, rounding);
}

TEST(Spacing, BetweenAFunctionAndItsArgument_IsThin) {
  EXPECT_NEAR(laidOut("\\cos 1").width - laidOut("\\mathrm{cos}1").width, thin, 0.02);
}

} // namespace
} // namespace halfspace::math
