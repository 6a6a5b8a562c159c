#include "lessons/lesson/prose.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

TEST(PlainProse, OfAWholeLine_ReadsLikeTheFormula) {
  EXPECT_EQ(
      plainProse("t = \\frac{(\\mark{P0}{P_0} - \\mark{Q}{Q})\\cdot \\mark{n}{\\vec n}}{\\mark{r}{\\vec "
                 "r}\\cdot \\mark{n}{\\vec n}} = -\\frac{10}{3}"),
      "t = ((P₀ − Q)·n)/(r·n) = −10/3");
}

TEST(PlainProse, OfMacros_ReadsWhatTheyStandFor) {
  const Macros macros{{"len", {1, "\\lvert #1\\rvert"}}, {"n", {0, "\\vec n"}}};
  EXPECT_EQ(plainProse("\\frac{1}{\\len\\n}", macros), "1/|n|");
}

TEST(PlainProse, OfSigns_TellsMinusFromNegative) {
  EXPECT_EQ(plainProse("-1 - 2\\cdot (-3) + \\left(-4,\\,-5\\right)"), "−1 − 2·(−3) + (−4, −5)");
}

TEST(PlainProse, OfRootsAndLengths_KeepsTheirParentheses) {
  EXPECT_EQ(plainProse("\\sqrt{3}"), "√3");
  EXPECT_EQ(plainProse("\\sqrt{n\\cdot n}"), "√(n·n)");
  EXPECT_EQ(plainProse("\\frac{f(Q)}{\\lvert\\vec n\\rvert}"), "f(Q)/|n|");
  EXPECT_EQ(plainProse("\\frac{1}{3}\\sqrt{3}"), "(1/3)√3");
  EXPECT_EQ(plainProse("\\lVert w \\rVert"), "‖w‖");
}

TEST(PlainProse, OfAFractionThatIsAFactor_CannotBeReadOtherwise) {
  EXPECT_EQ(plainProse("\\frac{1}{3}x + \\tfrac{2}{3}y - \\frac{30}{9}\\left(1,\\,2,\\,2\\right)"),
            "(1/3)x + (2/3)y − (30/9)(1, 2, 2)");
  EXPECT_EQ(plainProse("\\frac{f(Q)}{\\vec n\\cdot\\vec n}\\,\\vec n"), "(f(Q)/(n·n)) n");
  EXPECT_EQ(plainProse("\\frac{-840}{-560} = \\frac{3}{2}"), "−840/(−560) = 3/2");
  EXPECT_EQ(plainProse("\\frac{(a)(b) - (c)(d)}{D}"), "((a)(b) − (c)(d))/D");
}

TEST(PlainProse, OfScripts_RaisesAndLowers) {
  EXPECT_EQ(plainProse("\\vec u^{\\perp}"), "u⊥");
  EXPECT_EQ(plainProse("P_{12}^2 + 10^{-3} + a_n + b^{x+1}"), "P₁₂² + 10⁻³ + a_n + b^(x + 1)");
  EXPECT_EQ(plainProse("90^\\circ"), "90°");
}

TEST(PlainProse, OfWordsSpacesAndRelations_IsReadable) {
  EXPECT_EQ(plainProse("s \\geq 0,\\quad t \\leq 1"), "s ≥ 0, t ≤ 1");
  EXPECT_EQ(plainProse("x \\approx 3.14 \\;\\text{or so} \\neq \\theta"), "x ≈ 3.14 or so ≠ θ");
  EXPECT_EQ(plainProse("\\cos\\mark{theta}{\\theta}"), "cos θ");
  EXPECT_EQ(plainProse("\\bigl((x,\\,y) - 1\\bigr)"), "((x, y) − 1)");
}

TEST(PlainProse, OfBrokenLatex_EndsWithoutHarm) {
  for (const char *latex : {"\\frac{", "\\", "^", "_{", "}", "\\mark{a}", "\\sqrt", "\xC3"})
    EXPECT_LE(plainProse(latex).size(), 20U);
  EXPECT_EQ(plainProse(std::string(5000, '{')).find('}'), std::string::npos);
}

} // namespace
} // namespace halfspace
