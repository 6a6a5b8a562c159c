#include "tests/formula/described.h"
#include "tests/formula/laid_out.h"

namespace halfspace::math {
namespace {

TEST(Builders, ALineOfAWorkedExample_IsTheTreeThatLatexGives) {
  const Row built = row(letter('t'), symbol('=', AtomClass::Rel),
                        fraction(row(number("-30"), symbol(U'⋅', AtomClass::Bin), vector(row(letter('n')))),
                                 row(tagged("d", row(scripts(letter('d'), number("2"), row(letter('i'))))))));
  EXPECT_EQ(described(built), read("t=\\frac{-30\\cdot\\vec n}{\\mark{d}{d^2_i}}"));
}

TEST(Builders, AMatrix_IsTheTreeThatLatexGives) {
  const Row built = row(matrix('(', {{number("1"), number("0")}, {number("0"), number("1")}}, ')'));
  EXPECT_EQ(described(built), read("\\begin{pmatrix}1&0\\\\0&1\\end{pmatrix}"));
}

TEST(Builders, WithoutFences_AMatrixIsABareTable) {
  EXPECT_EQ(described(row(matrix(0, {{number("1")}}, 0))), "table[1]");
}

TEST(Builders, Scripts_TakeTheClassOfTheirOnlyBase) {
  EXPECT_EQ(scripts(symbol(')', AtomClass::Close), number("2"), {}).atomClass, AtomClass::Close);
  EXPECT_EQ(scripts(row(letter('a'), letter('b')), number("2"), {}).atomClass, AtomClass::Ord);
  EXPECT_EQ(scripts(row(tagged("s", row(largeOperator(U'∑')))), {}, {}).atomClass, AtomClass::Op);
}

TEST(Builders, LimitsOfAnOperator_AreKnownThroughItsTag) {
  EXPECT_EQ(scriptPlaceOf(row(tagged("s", row(largeOperator(U'∑'))))), ScriptPlace::LimitsInDisplay);
  EXPECT_EQ(scriptPlaceOf(row(brace(Side::Below, row(letter('x'))))), ScriptPlace::Limits);
  EXPECT_EQ(scriptPlaceOf({}), ScriptPlace::Beside);
}

TEST(Builders, AMinusInANumber_IsTheRealOne) { EXPECT_EQ(described(number("-2.5")), "−:Bin 2 . 5"); }

TEST(Builders, ATreeDeeperThanTheLayoutGoes_IsLaidOutWithoutItsInside) {
  Row deep = row(letter('x'));
  for (int i = 0; i < 3 * deepestLayout; ++i)
    deep = row(group(std::move(deep)));
  EXPECT_TRUE(layOut(deep, fonts()).glyphs.empty());
}

TEST(LayOut, ThousandsOfVeryTallBrackets_AreLeftOutAtTheLimit) {
  std::string source;
  for (int i = 0; i < 2000; ++i)
    source += "\\left(\\rule{1em}{99em}\\right)";
  EXPECT_EQ(layOut(parsed(source), fonts()).glyphs.size(), mostGlyphs);
}

} // namespace
} // namespace halfspace::math
