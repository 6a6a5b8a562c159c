// Terms as formulas that are laid out.
#include "tests/formula/laid_out.h"

#include "lessons/term/among_words.h"
#include "lessons/term/term.h"
#include "lessons/term/written.h"
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

class LiveNumbers : public testing::TestWithParam<LiveNumber> {};

/// The glyphs from left to right: parentheses that stretch are placed last.
std::vector<PlacedGlyph> fromLeft(const Layout &layout) {
  std::vector<PlacedGlyph> glyphs = layout.glyphs;
  std::sort(glyphs.begin(), glyphs.end(),
            [](const PlacedGlyph &a, const PlacedGlyph &b) { return a.x < b.x; });
  return glyphs;
}

TEST_P(LiveNumbers, AmongWords_AreSetAsTheirLatex) {
  const Layout set = layOut(formulaOf(GetParam()), fonts());
  const Layout read = laidOut(latexOf(GetParam()));
  EXPECT_NEAR(set.width, read.width, rounding);
  ASSERT_EQ(set.glyphs.size(), read.glyphs.size());
  for (std::size_t i = 0; i < read.glyphs.size(); ++i) {
    const PlacedGlyph glyph = fromLeft(set)[i];
    const PlacedGlyph wanted = fromLeft(read)[i];
    EXPECT_EQ(glyph.glyph, wanted.glyph) << i;
    EXPECT_NEAR(glyph.x, wanted.x, rounding) << i;
    EXPECT_NEAR(glyph.y, wanted.y, rounding) << i;
  }
}

Term aboutAnEighth() { return amongWords(halfspace::number(Rational(1234567890123, 9876543210987))); }

LiveNumber withSize(const Surd &root) {
  return {halfspace::number(root), halfspace::decimalOf(root, digitsAmongWords).term};
}

INSTANTIATE_TEST_SUITE_P(OfAllSorts, LiveNumbers,
                         testing::Values(LiveNumber{Term(-30)}, LiveNumber{Term(Rational(-10, 3))},
                                         LiveNumber{Term(Rational(5, 4))}, LiveNumber{aboutAnEighth()},
                                         LiveNumber{list({11, -15, 8})},
                                         LiveNumber{list({Rational(-10, 3), Rational(43, 3), 1})},
                                         LiveNumber{list({aboutAnEighth(), 2})}, withSize(Surd::root(6, 3)),
                                         withSize(Surd::root(5, Rational(-1, 2)))));

} // namespace
} // namespace halfspace::math
