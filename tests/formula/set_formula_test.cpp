#include "widgets/formula/set_formula.h"

#include "tests/formula/laid_out.h"

namespace halfspace::math {
namespace {

TEST(SetFormula, OfGoodLatex_IsTheFormulaWithoutAnError) {
  const SetFormula formula = setLatex("x + 1", fonts());
  EXPECT_EQ(formula.error, "");
  EXPECT_EQ(formula.layout.width, laidOut("x + 1").width);
}

TEST(SetFormula, OfLatexThatCannotBeRead_ShowsItsSourceAndWhere) {
  const SetFormula formula = setLatex("x + \\foo", fonts());
  EXPECT_NE(formula.error.find("\\foo"), std::string::npos);
  EXPECT_EQ(formula.errorColumn, 5U);
  EXPECT_EQ(formula.layout.glyphs.size(), 8U) << "its eight characters";
}

TEST(SetFormula, OfALongSource_ShowsItsBeginningOnOneLine) {
  const SetFormula few = setLatex("  \\foo \n\n  a  ", fonts());
  const SetFormula same = setLatex("\\foo a", fonts());
  EXPECT_EQ(few.layout.width, same.layout.width);
  const SetFormula many = setLatex("\\foo " + std::string(1000, 'a'), fonts());
  EXPECT_LT(many.layout.width, 61);
  EXPECT_GT(many.layout.width, 20);
}

TEST(SetFormula, LargerThanAnybodyCouldRead_IsRefused) {
  std::string latex;
  for (int i = 0; i < 2000; ++i)
    latex += "+x_1";
  const SetFormula wide = setLatex(latex, fonts());
  EXPECT_NE(wide.error, "");
  EXPECT_LT(wide.layout.width, largestFormula);
  const SetFormula endless = setLatex("\\rule{1e999em}{1em}", fonts());
  EXPECT_NE(endless.error, "");
}

TEST(SetFormula, OfBytesThatAreNoText_ShowsSomething) {
  const SetFormula formula = setLatex("\\foo \xFF\xC3", fonts());
  EXPECT_NE(formula.error, "");
  EXPECT_FALSE(formula.layout.glyphs.empty());
}

} // namespace
} // namespace halfspace::math
