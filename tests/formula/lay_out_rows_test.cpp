// Rows: the spaces between atoms of every two classes, styles and colours, and the pieces that lines are
// broken between.
#include "tests/formula/laid_out.h"

#include <iterator>
#include <sstream>

namespace halfspace::math {
namespace {

constexpr double mu = 1.0 / 18;

/// The classes but Bin, which is one only between two terms.
const std::vector<std::string> classes{"ord", "op", "rel", "open", "close", "punct", "inner"};

/// The TeXbook's table of spaces, page 170, by rows of what stands left: 0 none, 1 thin, 3 thick; in
/// parentheses: not in scripts.
const std::vector<std::string> table{"0  1  (3) 0   0  0   (1)", "1  1  (3) 0   0  0   (1)",
                                     "(3) (3) 0 (3) 0  0  (3)",  "0  0  0   0   0  0   0",
                                     "0  1  (3) 0   0  0   (1)", "(1) (1) (1) (1) (1) (1) (1)",
                                     "(1) 1 (3) (1) 0  (1) (1)"};

/// The entries of a row of the table.
std::vector<std::string> entriesOf(const std::string &row) {
  std::istringstream words(row);
  return {std::istream_iterator<std::string>(words), {}};
}

struct EveryTwoClasses : testing::TestWithParam<Style> {
  /// The space between two atoms, in em of their style.
  static double between(const std::string &left, const std::string &right, Style style) {
    const auto width = [style](const std::string &latex) { return laidOut(latex, style).width; };
    const double alone = width("0") + width("1");
    return (width("\\math" + left + "{0}\\math" + right + "{1}") - alone) / (width("\\rule{1em}{1em}"));
  }
};

TEST_P(EveryTwoClasses, StandApartAsTheTexbookSays) {
  const bool isScript = GetParam() >= Style::Script;
  for (std::size_t left = 0; left < classes.size(); ++left)
    for (std::size_t right = 0; right < classes.size(); ++right) {
      std::string entry = entriesOf(table[left]).at(right);
      const bool notInScripts = entry.front() == '(';
      if (notInScripts)
        entry = entry.substr(1, 1);
      const int kind = isScript && notInScripts ? 0 : std::stoi(entry);
      const double expected = kind == 0 ? 0 : (kind + 2) * mu;
      EXPECT_NEAR(between(classes[left], classes[right], GetParam()), expected, 1e-6)
          << classes[left] << " " << classes[right];
    }
}

INSTANTIATE_TEST_SUITE_P(Styles, EveryTwoClasses,
                         testing::Values(Style::Display, Style::Text, Style::Script, Style::ScriptScript));

TEST(Styles, SwitchedInARow_HoldToItsEnd) {
  const Layout layout = laidOut("1{\\scriptstyle 2 3}4");
  EXPECT_EQ(glyphIn(layout, '1').size, 1);
  EXPECT_LT(glyphIn(layout, '2').size, 1);
  EXPECT_EQ(glyphIn(layout, '2').size, glyphIn(layout, '3').size);
  EXPECT_EQ(glyphIn(layout, '4').size, 1);
}

TEST(Styles, SwitchedInATag_HoldToItsEnd) {
  const Layout layout = laidOut("\\mark{a}{\\scriptstyle 2}4");
  EXPECT_LT(glyphIn(layout, '2').size, 1);
  EXPECT_EQ(glyphIn(layout, '4').size, 1);
}

TEST(Spaces, InScripts_AreAsSmallAsTheirLetters) {
  const double wide = laidOut("x^{1\\quad 2}").width - laidOut("x^{12}").width;
  EXPECT_NEAR(wide, 0.7, 0.01);
}

TEST(Colours, OfTheFormula_AreThoseOfTheInnermost) {
  const Layout layout = laidOut("1\\color{red}{2\\frac{3}{\\color{blue}{4}}}5");
  const auto colorOf = [&](char32_t digit) { return glyphIn(layout, digit).ink.color; };
  const Color red{255, 0, 0};
  EXPECT_FALSE(colorOf('1') || colorOf('5'));
  EXPECT_EQ(colorOf('2'), red);
  EXPECT_EQ(colorOf('3'), red);
  EXPECT_EQ(colorOf('4'), (Color{0, 0, 255}));
  ASSERT_EQ(layout.rules.size(), 1U);
  EXPECT_EQ(layout.rules.front().ink.color, red) << "the fraction's bar too";
}

TEST(Colours, OfAMiddleFence_AreThoseAroundIt) {
  const Layout layout = laidOut("\\left(\\frac 12\\color{red}{\\middle|}3\\right)");
  int redRules = 0;
  for (const Rule &rule : layout.rules)
    redRules += rule.ink.color.has_value();
  EXPECT_EQ(redRules, 1);
}

/// What may begin a line, atom by atom: S statement, R relation, + sign, * product,
/// `,` entry, ( inside, ) a product inside, - never.
std::string breaksOf(const std::string &latex) {
  std::string text;
  for (const Piece &piece : laidOut(latex).pieces)
    text += "SR+*,()-"[static_cast<std::size_t>(piece.before)];
  return text;
}

TEST(Pieces, OfARow_SayWhereItsLinesCanBeBroken) {
  EXPECT_EQ(breaksOf("a=b+c\\cdot d"), "-R-+-*-");
  EXPECT_EQ(breaksOf("(a+b)=c"), "--(--R-");
  EXPECT_EQ(breaksOf("|a-b|-c"), "--(--+-");
  EXPECT_EQ(breaksOf("(a\\cdot b)"), "--)--");
  EXPECT_EQ(breaksOf("\\left(a+b\\right)-c"), "-+-") << "one atom";
}

TEST(Pieces, BehindAWideSpace_BeginAStatementOutsideOfParentheses) {
  EXPECT_EQ(breaksOf("a,\\quad b"), "--S");
  EXPECT_EQ(breaksOf("a,\\;b"), "---");
  EXPECT_EQ(breaksOf("(a,\\quad b)"), "---,-");
}

TEST(Pieces, WithATagAround_AreThePiecesOfTheTag) {
  const Layout layout = laidOut("a+\\mark{m}{b+c}+d");
  ASSERT_EQ(layout.taggedPieces.size(), 1U);
  EXPECT_EQ(layout.taggedPieces.front().begin, 2U);
  EXPECT_EQ(layout.taggedPieces.front().end, 5U);
  EXPECT_EQ(breaksOf("a+\\mark{m}{b+c}+d"), "-+-+-+-") << "lines break inside of it";
}

TEST(Pieces, OneBehindTheOther_TileTheRow) {
  for (const char *latex : {"a=b+c\\cdot d", "\\frac 12+\\sqrt x", "\\sum_{i=1}^n a_i"}) {
    const Layout layout = laidOut(latex);
    for (std::size_t i = 0; i < layout.pieces.size(); ++i) {
      const Piece &piece = layout.pieces[i];
      EXPECT_LE(piece.x, piece.right);
      EXPECT_GE(piece.x, i == 0 ? 0 : layout.pieces[i - 1].right - rounding) << latex;
      EXPECT_LE(piece.ascent, layout.ascent + rounding);
      EXPECT_LE(piece.depth, layout.depth + rounding);
    }
    EXPECT_NEAR(layout.pieces.back().right, layout.width, rounding);
  }
}

} // namespace
} // namespace halfspace::math
