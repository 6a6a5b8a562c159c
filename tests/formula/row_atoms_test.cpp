// What the atoms of a row are to each other, without any font.
#include "widgets/formula/row_atoms.h"

#include "widgets/formula/read_latex.h"

#include <gtest/gtest.h>

namespace halfspace::math {
namespace {

/// A row of LaTeX, settled.
struct Settled {
  explicit Settled(std::string_view latex, std::optional<AtomClass> before = {})
      : row(std::get<Row>(readLatex(latex))) {
    for (const Node &node : row)
      atoms.push_back({&node, node.atomClass, 0});
    settle(atoms, before);
  }
  /// A letter for each atom: o for Ord, p Op, b Bin, r Rel, ( Open, ) Close, `,` Punct, i Inner.
  [[nodiscard]] std::string classes() const {
    std::string text;
    for (const RowAtom &atom : atoms)
      text += "opbr(),i"[static_cast<std::size_t>(atom.atomClass)];
    return text;
  }
  /// How deep each atom lies: `<` opens a parenthesis, `>` closes one, `.` does neither.
  [[nodiscard]] std::string nesting() const {
    std::string text;
    for (const RowAtom &atom : atoms)
      text += atom.nesting > 0 ? '<' : atom.nesting < 0 ? '>' : '.';
    return text;
  }

  Row row;
  std::vector<RowAtom> atoms;
};

struct Signs {
  const char *latex;
  const char *classes;
};

struct SettledSigns : testing::TestWithParam<Signs> {};

TEST_P(SettledSigns, CombineOnlyWhereTheyStandBetweenTwoTerms) {
  EXPECT_EQ(Settled(GetParam().latex).classes(), GetParam().classes);
}

INSTANTIATE_TEST_SUITE_P(Rows, SettledSigns,
                         testing::Values(Signs{"a-b", "obo"}, Signs{"-b", "oo"}, Signs{"a--b", "oboo"},
                                         Signs{"a=-b", "oroo"}, Signs{"a-=b", "ooro"},
                                         Signs{"(-a)-b", "(oo)bo"}, Signs{"(a-)", "(oo)"},
                                         Signs{"a,-b", "o,oo"}, Signs{"\\cos-a", "poo"}, Signs{"a-", "oo"},
                                         Signs{"a!-b", "o)bo"}, Signs{"\\left(a\\right)-b", "ibo"},
                                         Signs{"a-,b", "oo,o"}),
                         [](const auto &each) { return "Row" + std::to_string(each.index); });

TEST(Settle, ASignAtTheBeginning_CombinesWithWhatStandsBeforeTheRow) {
  EXPECT_EQ(Settled("-b", AtomClass::Ord).classes(), "bo");
  EXPECT_EQ(Settled("-b", AtomClass::Rel).classes(), "oo");
}

struct Bars {
  const char *latex;
  const char *nesting;
};

struct SettledBars : testing::TestWithParam<Bars> {};

TEST_P(SettledBars, OpenWhereATermIsDueAndCloseBehindOne) {
  EXPECT_EQ(Settled(GetParam().latex).nesting(), GetParam().nesting);
}

INSTANTIATE_TEST_SUITE_P(Rows, SettledBars,
                         testing::Values(Bars{"|a|", "<.>"}, Bars{"|a||b|", "<.><.>"}, Bars{"a=|b|", "..<.>"},
                                         Bars{"\\|a\\|-|b|", "<.>.<.>"}, Bars{"(a|b)", "<...>"},
                                         Bars{"n!", ".."}, Bars{"a|", ".."}, Bars{"||a|-b|", "<<.>..>"},
                                         Bars{"(a)^2", "<.>"}, Bars{"\\bigl(a\\bigr)", "<.>"}),
                         [](const auto &each) { return "Row" + std::to_string(each.index); });

/// The break before the second atom of a row.
Break secondBreak(std::string_view latex, int parentheses = 0) {
  const Settled row(latex);
  return breakBefore(row.atoms.at(1), parentheses, row.atoms.front().atomClass);
}

TEST(Breaks, BeforeSigns_AreTheBetterTheMoreTheySetApart) {
  EXPECT_EQ(secondBreak("a=b"), Break::Relation);
  EXPECT_EQ(secondBreak("a\\leq b"), Break::Relation);
  EXPECT_EQ(secondBreak("a-b"), Break::Sign);
  EXPECT_EQ(secondBreak("a\\pm b"), Break::Sign);
  EXPECT_EQ(secondBreak("a\\cdot b"), Break::Product);
  EXPECT_LT(Break::Relation, Break::Sign);
  EXPECT_LT(Break::Sign, Break::Product);
}

TEST(Breaks, BehindACommaInParentheses_AreBetterThanBeforeASignThere) {
  EXPECT_EQ(secondBreak(",b", 1), Break::Entry);
  EXPECT_EQ(secondBreak(",b"), Break::Never);
  EXPECT_LT(Break::Entry, Break::Inside);
}

TEST(Breaks, InsideParentheses_AreTheWorst) {
  for (const char *latex : {"a=b", "a-b"})
    EXPECT_EQ(secondBreak(latex, 1), Break::Inside) << latex;
  EXPECT_EQ(secondBreak("a\\times b", 1), Break::InsideProduct);
  EXPECT_LT(Break::Product, Break::Inside);
  EXPECT_LT(Break::Inside, Break::InsideProduct);
}

TEST(Breaks, BeforeLettersAndSignsOfTheirOwn_AreNever) {
  EXPECT_EQ(secondBreak("ab"), Break::Never);
  EXPECT_EQ(secondBreak("a,b"), Break::Never);
  EXPECT_EQ(secondBreak("=-b"), Break::Never) << "this minus belongs to b";
  EXPECT_EQ(secondBreak("=-b", 1), Break::Never);
}

} // namespace
} // namespace halfspace::math
