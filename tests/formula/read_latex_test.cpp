#include "tests/formula/described.h"

#include <gtest/gtest.h>

namespace halfspace::math {
namespace {

TEST(ReadLatex, Letters_AreItalicAndDigitsUpright) {
  EXPECT_EQ(read("x2"), "x 2");
  EXPECT_EQ(read("\\mathrm{x}"), "upright x");
  EXPECT_EQ(read("\\mathbf{v}\\mathbb R"), "𝐯 ℝ");
  EXPECT_EQ(read("{\\bf A}B"), "𝐀 B");
}

TEST(ReadLatex, GreekLetters_AreItalicWhenSmallAndUprightWhenCapital) {
  EXPECT_EQ(read("\\lambda\\Gamma"), "𝜆 Γ");
  EXPECT_EQ(read("\\boldsymbol{\\lambda\\Gamma}"), "{𝝀 𝜞}");
}

TEST(ReadLatex, Signs_HaveTheirClasses) {
  EXPECT_EQ(read("a+b=c"), "a +:Bin b =:Rel c");
  EXPECT_EQ(read("(a,b)"), "(:Open a ,:Punct b ):Close");
  EXPECT_EQ(read("a\\cdot b\\leq c"), "a ⋅:Bin b ≤:Rel c");
}

TEST(ReadLatex, AHyphen_IsAMinus) { EXPECT_EQ(read("-1"), "−:Bin 1"); }

TEST(ReadLatex, TypedCharacters_AreWhatTheirCommandsAre) {
  EXPECT_EQ(read("λ·μ ≤ −x"), read("\\lambda\\cdot\\mu\\leq -x"));
  EXPECT_EQ(read("α×β ≈ ∞"), read("\\alpha\\times\\beta\\approx\\infty"));
  EXPECT_EQ(read("∑_i"), read("\\sum_i"));
  EXPECT_EQ(read("x ∈ ℝ"), "x ∈:Rel ℝ");
  EXPECT_EQ(read("u⊥v"), "u ⊥:Rel v");
}

TEST(ReadLatex, TypedScripts_AreScripts) {
  EXPECT_EQ(read("x²"), read("x^2"));
  EXPECT_EQ(read("P₀"), read("P_0"));
  EXPECT_EQ(read("A⁻¹"), read("A^{-1}"));
  EXPECT_EQ(read("x₁₂²"), read("x_{12}^2"));
}

TEST(ReadLatex, ACombiningArrow_IsAnAccent) { EXPECT_EQ(read("v\u20D7"), read("\\vec v")); }

TEST(ReadLatex, Scripts_ComeInEitherOrder) {
  EXPECT_EQ(read("x_1^2"), "scripts(x|2|1)");
  EXPECT_EQ(read("x^2_1"), "scripts(x|2|1)");
  EXPECT_EQ(read("x^{a+b}"), "scripts(x|a +:Bin b|)");
  EXPECT_EQ(read("{}^tA"), "scripts({}|t|) A");
  EXPECT_EQ(read("^2"), "scripts({}|2|)");
  EXPECT_EQ(read("\\,_1"), "space(0.167) scripts({}||1)");
}

TEST(ReadLatex, Primes_AreSuperscripts) {
  EXPECT_EQ(read("f'"), "scripts(f|′|)");
  EXPECT_EQ(read("f''"), "scripts(f|″|)");
  EXPECT_EQ(read("f'^2"), "scripts(f|′ 2|)");
  EXPECT_EQ(read("f'_1"), "scripts(f|′|1)");
  EXPECT_EQ(read("f'''''"), "scripts(f|⁗ ′|)");
}

TEST(ReadLatex, Braces_MakeASymbolOrdinaryAndARowOneAtom) {
  EXPECT_EQ(read("{=}"), "=");
  EXPECT_EQ(read("2{,}5"), "2 , 5");
  EXPECT_EQ(read("{ab}^2"), "scripts({a b}|2|)");
}

TEST(ReadLatex, Fractions) {
  EXPECT_EQ(read("\\frac12"), "frac(1|2)");
  EXPECT_EQ(read("\\frac{a}{b+c}"), "frac(a|b +:Bin c)");
  EXPECT_EQ(read("\\tfrac12\\dfrac34"), "frac1(1|2) frac0(3|4)");
  EXPECT_EQ(read("{a \\over b}"), "{frac(a|b)}");
  EXPECT_EQ(read("\\binom nk"), "fenced((|over(n|k)|))");
  EXPECT_EQ(read("{n \\choose k}"), "{fenced((|over(n|k)|)):Inner}");
}

TEST(ReadLatex, Roots) {
  EXPECT_EQ(read("\\sqrt x"), "root(x|)");
  EXPECT_EQ(read("\\sqrt[3]{x+1}"), "root(x +:Bin 1|3)");
  EXPECT_EQ(read("\\sqrt[{[n]}]x"), "root(x|{[:Open n ]:Close})");
}

TEST(ReadLatex, Fences) {
  EXPECT_EQ(read("\\left(x\\right]"), "fenced((|x|]):Inner");
  EXPECT_EQ(read("\\left.x\\right|"), "fenced(.|x||):Inner");
  EXPECT_EQ(read("\\left\\{a\\middle|b\\right\\}"), "fenced({|a middle|:Rel b|}):Inner");
  EXPECT_EQ(read("\\left<x\\right\\rangle"), "fenced(⟨|x|⟩):Inner");
  EXPECT_EQ(read("\\bigl(x\\Bigr)"), "tall1.19(:Open x tall1.79):Close");
}

TEST(ReadLatex, AccentsBarsAndBraces) {
  EXPECT_EQ(read("\\vec n\\cdot\\vec{P}"), "accent(8407|n) ⋅:Bin accent(8407|P)");
  EXPECT_EQ(read("\\overline{AB}\\underline x"), "overline(A B) underline(x)");
  EXPECT_EQ(read("\\underbrace{x}_{n}"), "scripts(brace⏟(x):Op||n):Op");
  EXPECT_EQ(read("\\overrightarrow{AB}"), "wide(8407|A B)");
  EXPECT_EQ(read("\\overset{!}{=}"), "stack(=:Rel|!:Close|):Rel");
  EXPECT_EQ(read("\\overset{!}="), "stack(=:Rel|!:Close|):Rel");
  EXPECT_EQ(read("\\xrightarrow[b]{a}"), "arrow→(a|b):Rel");
}

TEST(ReadLatex, Operators) {
  EXPECT_EQ(read("\\sum_{i=1}^n"), "scripts(large ∑:Op|n|i =:Rel 1):Op");
  EXPECT_EQ(read("\\cos\\theta"), "\"cos\":Op 𝜃");
  EXPECT_EQ(read("\\operatorname{area}(P)"), "\"area\":Op (:Open P ):Close");
  EXPECT_EQ(read("a \\bmod n"), "a \"mod\":Bin n");
  EXPECT_EQ(read("\\mathop{XX}"), "{X X}:Op");
}

TEST(ReadLatex, Not_TakesTheNegatedCharacterWhereThereIsOne) {
  EXPECT_EQ(read("a\\not=b"), "a ≠:Rel b");
  EXPECT_EQ(read("a\\not\\parallel b"), "a ∦:Rel b");
  EXPECT_EQ(read("a\\not\\perp b"), "a not(⟂:Rel):Rel b");
}

TEST(ReadLatex, Dots_StandOnTheAxisBeforeAnOperation) {
  EXPECT_EQ(read("a,\\dots,b"), "a ,:Punct {.:Punct .:Punct .:Punct}:Inner ,:Punct b");
  EXPECT_EQ(read("a+\\dots+b"), "a +:Bin {⋅:Punct ⋅:Punct ⋅:Punct}:Inner +:Bin b");
}

TEST(ReadLatex, Matrices) {
  EXPECT_EQ(read("\\begin{matrix}a&b\\\\c&d\\end{matrix}"), "table[a & b][c & d]");
  EXPECT_EQ(read("\\begin{vmatrix}a\\\\\\end{vmatrix}"), "fenced(||table[a]||):Inner");
  EXPECT_EQ(read("\\begin{cases}a&b\\\\c\\end{cases}"), "fenced({|table[a & b][c]|.):Inner");
  EXPECT_EQ(read("\\begin{matrix}\\end{matrix}"), "table");
}

TEST(ReadLatex, Arrays_HaveColumnsAndRules) {
  const auto result =
      readLatex("\\begin{array}{r|lc||}\\hline a&b\\\\[2pt] \\hline\\hline c\\\\\\hline\\end{array}");
  const auto &table = std::get<Table>(std::get<Row>(result).front().content);
  EXPECT_EQ(table.columns, (std::vector{Align::Right, Align::Left, Align::Center}));
  EXPECT_EQ(table.columnRules, (std::vector{0, 1, 0, 2}));
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0].rulesAbove, 1);
  EXPECT_DOUBLE_EQ(table.rows[0].roomBelow, 0.2);
  EXPECT_EQ(table.rows[1].rulesAbove, 2);
  EXPECT_EQ(table.rulesBelow, 1);
}

TEST(ReadLatex, ABracketBehindASpace_BelongsToTheNextRow) {
  EXPECT_EQ(read("\\begin{matrix}a\\\\ [b]\\end{matrix}"), "table[a][[:Open b ]:Close]");
}

TEST(ReadLatex, Alignments) {
  EXPECT_EQ(read("\\begin{align*}a&=b\\\\&=c\\end{align*}"), "table[a & =:Rel b][ & =:Rel c]");
  EXPECT_EQ(read("a&=b\\\\c&=d"), "table[a & =:Rel b][c & =:Rel d]");
  EXPECT_EQ(read("a\\\\b"), "table[a][b]");
}

TEST(ReadLatex, Text_KeepsItsSpaces) {
  EXPECT_EQ(read("\\text{ if  so}"), "\" if so\"");
  EXPECT_EQ(read("\\text{если}"), "\"если\"");
  EXPECT_EQ(read("\\text{50\\% {of} it}"), "\"50% of it\"");
}

TEST(ReadLatex, Text_HoldsFormulas) {
  EXPECT_EQ(read("\\text{if $x>0$, so}"), "{\"if \" {x >:Rel 0} \", so\"}");
  EXPECT_EQ(read("\\text{a \\textbf{b}}"), "{\"a \" \"b\"}");
}

TEST(ReadLatex, Tags_Nest) {
  EXPECT_EQ(read("\\mark{a}{x+\\mark{b.c-1}{y}}"), "tag(a|x +:Bin tag(b.c-1|y))");
  EXPECT_EQ(read("\\mark{a}x^2"), "scripts(tag(a|x)|2|)");
}

TEST(ReadLatex, Colours) {
  EXPECT_EQ(read("\\color{red}{x}y"), "color(255,0,0|x) y");
  EXPECT_EQ(read("\\textcolor{#0a0B0c}{x}"), "color(10,11,12|x)");
}

TEST(ReadLatex, SpacesAndStyles) {
  EXPECT_EQ(read("a\\,b\\quad c"), "a space(0.167) b space(1) c");
  EXPECT_EQ(read("\\hspace{2em}\\kern-1.5em\\mkern 18mu"), "space(2) space(-1.5) space(1)");
  EXPECT_EQ(read("\\displaystyle x"), "style(0) x");
}

TEST(ReadLatex, Comments_AreLeftOut) { EXPECT_EQ(read("a% b }\n c"), "a c"); }

TEST(ReadLatex, NothingAndSpaces_AreAnEmptyFormula) {
  EXPECT_EQ(read(""), "");
  EXPECT_EQ(read(" \n "), "");
}

} // namespace
} // namespace halfspace::math
