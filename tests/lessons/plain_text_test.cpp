#include "lessons/working.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

TEST(PlainText, OfAWholeLine_ReadsLikeTheFormula) {
  EXPECT_EQ(plainText("t = \\frac{(\\mark{P0}{P_0} - \\mark{Q}{Q})\\cdot \\mark{n}{\\vec n}}{\\mark{r}{\\vec "
                      "r}\\cdot \\mark{n}{\\vec n}} = -\\frac{10}{3}"),
            "t = ((P₀ − Q)·n)/(r·n) = −10/3");
}

TEST(PlainText, OfSigns_TellsMinusFromNegative) {
  EXPECT_EQ(plainText("-1 - 2\\cdot (-3) + \\left(-4,\\,-5\\right)"), "−1 − 2·(−3) + (−4, −5)");
}

TEST(PlainText, OfRootsAndLengths_KeepsTheirParentheses) {
  EXPECT_EQ(plainText("\\sqrt{3}"), "√3");
  EXPECT_EQ(plainText("\\sqrt{n\\cdot n}"), "√(n·n)");
  EXPECT_EQ(plainText("\\frac{f(Q)}{\\lvert\\vec n\\rvert}"), "f(Q)/|n|");
  EXPECT_EQ(plainText("\\frac{1}{3}\\sqrt{3}"), "(1/3)√3");
  EXPECT_EQ(plainText("\\lVert w \\rVert"), "‖w‖");
}

TEST(PlainText, OfAFractionThatIsAFactor_CannotBeReadOtherwise) {
  EXPECT_EQ(plainText("\\frac{1}{3}x + \\tfrac{2}{3}y - \\frac{30}{9}\\left(1,\\,2,\\,2\\right)"),
            "(1/3)x + (2/3)y − (30/9)(1, 2, 2)");
  EXPECT_EQ(plainText("\\frac{f(Q)}{\\vec n\\cdot\\vec n}\\,\\vec n"), "(f(Q)/(n·n)) n");
  EXPECT_EQ(plainText("\\frac{-840}{-560} = \\frac{3}{2}"), "−840/(−560) = 3/2");
  EXPECT_EQ(plainText("\\frac{(a)(b) - (c)(d)}{D}"), "((a)(b) − (c)(d))/D");
}

TEST(PlainText, OfScripts_RaisesAndLowers) {
  EXPECT_EQ(plainText("\\vec u^{\\perp}"), "u⊥");
  EXPECT_EQ(plainText("P_{12}^2 + 10^{-3} + a_n + b^{x+1}"), "P₁₂² + 10⁻³ + a_n + b^(x + 1)");
  EXPECT_EQ(plainText("90^\\circ"), "90°");
}

TEST(PlainText, OfWordsSpacesAndRelations_IsReadable) {
  EXPECT_EQ(plainText("s \\geq 0,\\quad t \\leq 1"), "s ≥ 0, t ≤ 1");
  EXPECT_EQ(plainText("x \\approx 3.14 \\;\\text{or so} \\neq \\theta"), "x ≈ 3.14 or so ≠ θ");
  EXPECT_EQ(plainText("\\cos\\mark{theta}{\\theta}"), "cos θ");
  EXPECT_EQ(plainText("\\bigl((x,\\,y) - 1\\bigr)"), "((x, y) − 1)");
}

TEST(PlainText, OfBrokenLatex_EndsWithoutHarm) {
  for (const char *latex : {"\\frac{", "\\", "^", "_{", "}", "\\mark{a}", "\\sqrt", "\xC3"})
    EXPECT_LE(plainText(latex).size(), 20U);
  EXPECT_EQ(plainText(std::string(5000, '{')).find('}'), std::string::npos);
}

TEST(MarksNamed, InALine_ComeInOrderAndOnce) {
  EXPECT_EQ(marksNamedIn("\\mark{b}{\\mark{a}{x}} + \\mark{b}{y}"), (std::vector<std::string>{"b", "a"}));
}

TEST(WithoutMarks, LeavesPlainLatex) {
  EXPECT_EQ(withoutMarks("\\mark{F}{F} = \\mark{Q}{Q - \\mark{n}{\\vec n}}"), "F = Q - \\vec n");
}

TEST(WithoutMarks, WhereAPieceWouldRunIntoACommand_KeepsItApart) {
  EXPECT_EQ(withoutMarks("\\cdot\\mark{n}{n}^\\mark{k}{2k}"), "\\cdot{n}^{2k}");
  EXPECT_EQ(withoutMarks("\\cos\\mark{theta}{\\theta}"), "\\cos\\theta");
}

} // namespace
} // namespace halfspace
