// Terms as formulas that are laid out.
#include "tests/formula/laid_out.h"

#include "lessons/term/term.h"
#include "widgets/formula/break_lines.h"
#include "widgets/formula/term_formula.h"

namespace halfspace::math {
namespace {

Layout coordinates() {
  return layOut(formulaOf(list({Rational(-10, 3), Rational(43, 3), Rational(4, 3)})), fonts());
}

TEST(TermFormula, ListOfFractions_ThatIsTooWide_IsBrokenBehindAComma) {
  const Layout whole = coordinates();
  LineRules rules;
  rules.width = 0.8 * whole.width;
  const Layout broken = breakLines(whole, rules);
  EXPECT_EQ(broken.lines.size(), 2U);
  EXPECT_LE(broken.width, rules.width);
  const auto commas = glyphsOf(broken, U',');
  ASSERT_EQ(commas.size(), 2U);
  EXPECT_EQ(commas.back().y, broken.lines.front().baseline);
}

TEST(TermFormula, ParenthesesAroundFractions_AreAsTallAsThoseThatStretch) {
  const Layout stretched = laidOut("\\left(\\tfrac{43}{3}\\right)");
  EXPECT_EQ(coordinates().glyphs.back().glyph, stretched.glyphs.back().glyph);
}

TEST(TermFormula, FractionAmongWords_HasASlash_AndDigitsOfUsualSize) {
  const Layout layout = layOut(formulaOf(Term(Rational(-12, 7)), Fractions::Flat), fonts());
  EXPECT_EQ(glyphsOf(layout, U'/').size(), 1U);
  EXPECT_TRUE(layout.rules.empty());
  for (const auto &glyph : layout.glyphs)
    EXPECT_EQ(glyph.size, 1);
}

TEST(TermFormula, FractionAboveABar_HasASlash) {
  const Term quotient = Term(Rational(-15, 2)) / Term(Rational(1, 3));
  const Layout layout = layOut(formulaOf(quotient), fonts());
  EXPECT_EQ(glyphsOf(layout, U'/').size(), 2U);
  EXPECT_EQ(layout.rules.size(), 1U) << "one bar";
}

} // namespace
} // namespace halfspace::math
