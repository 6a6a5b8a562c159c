#include "lessons/pseudo_language.h"
#include "tests/formula/described.h"
#include "tests/lessons/spoken_to_in.h"
#include "tests/untranslated.h"

#include <gtest/gtest.h>

#include <string>

namespace halfspace::math {
namespace {

std::string repeated(std::string_view piece, int count) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += piece;
  return text;
}

TEST(ReadLatexError, AnUnknownCommand_IsNamedAtItsColumn) {
  EXPECT_EQ(read("a+\\foo b"), "error 3: `\\foo` is unknown.");
}

TEST(ReadLatexError, Columns_CountCharactersNotBytes) {
  EXPECT_EQ(read("λ·𝑥\\foo"), "error 4: `\\foo` is unknown.");
}

TEST(ReadLatexError, AMissingBrace_IsToldAtItsOpeningOne) {
  EXPECT_EQ(read("x^{2"), "error 3: A `}` is missing for this `{`.");
  EXPECT_EQ(read("\\text{ab"), "error 6: A `}` is missing for this `{`.");
  EXPECT_EQ(read("\\mark{a"), "error 6: A `}` is missing for this `{`.");
  EXPECT_EQ(read("\\left({x\\right)"), "error 7: A `}` is missing for this `{`.");
}

TEST(ReadLatexError, AStrayCharacter_IsToldWhereItStands) {
  EXPECT_EQ(read("x}"), "error 2: This `}` has no `{`.");
  EXPECT_EQ(read("{x&y}"), "error 3: `&` can stand only in a table.");
  EXPECT_EQ(read("a$b"), "error 2: `$` cannot stand inside a formula.");
  EXPECT_EQ(read("a#"), "error 2: `#` cannot stand here.");
  EXPECT_EQ(read("{a\\\\b}"), "error 3: `\\\\` cannot stand here.");
}

TEST(ReadLatexError, FencesThatDoNotClose_AreTold) {
  EXPECT_EQ(read("a\\left(x"), "error 2: A `\\right` is missing for this `\\left`.");
  EXPECT_EQ(read("x\\right)"), "error 2: This `\\right` has no `\\left`.");
  EXPECT_EQ(read("\\left x y\\right)"), "error 7: `x` is no bracket.");
  EXPECT_EQ(read("\\big"), "error 1: A bracket is missing behind this command.");
  EXPECT_EQ(read("a\\middle|b"), "error 2: `\\middle` can stand only between `\\left` and `\\right`.");
}

TEST(ReadLatexError, EnvironmentsThatDoNotClose_AreTold) {
  EXPECT_EQ(read("\\begin{matrix}a"), "error 1: A `\\end{matrix}` is missing for this `\\begin{matrix}`.");
  EXPECT_EQ(read("\\begin{matrix}a\\end{pmatrix}"),
            "error 16: `\\end{pmatrix}` stands where `\\end{matrix}` is due.");
  EXPECT_EQ(read("\\begin{tikz}\\end{tikz}"), "error 1: The environment `tikz` is unknown.");
  EXPECT_EQ(read("a\\end{matrix}"), "error 2: This `\\end` has no `\\begin`.");
  EXPECT_EQ(read("\\begin{array}{x}a\\end{array}"),
            "error 14: A table's columns are `l`, `c` and `r`, with `|` for a rule.");
}

TEST(ReadLatexError, Scripts_AreToldWhenThereAreTwo) {
  EXPECT_EQ(read("x^a^b"), "error 4: There are two superscripts: put the first with its base into `{}`.");
  EXPECT_EQ(read("x_a^c_b"), "error 6: There are two subscripts: put the first with its base into `{}`.");
}

TEST(ReadLatexError, MissingArguments_AreTold) {
  EXPECT_EQ(read("\\frac1"), "error 7: An argument is missing here.");
  EXPECT_EQ(read("x^"), "error 3: An argument is missing here.");
  EXPECT_EQ(read("\\limits"), "error 1: `\\limits` cannot stand here.");
  EXPECT_EQ(read("\\"), "error 1: A command's name is missing behind the `\\`.");
}

TEST(ReadLatexError, MarksColoursAndLengths_AreChecked) {
  EXPECT_EQ(read("\\mark{a b}{x}"),
            "error 1: The mark `a b` is not made of letters, digits, `.`, `-` and `_`.");
  EXPECT_EQ(read("\\color{rot}{x}"), "error 1: The colour `rot` is unknown: write it as `#rrggbb`.");
  EXPECT_EQ(read("\\hspace{2}"), "error 1: `2` is no length: write it as `2em` or `5pt`.");
  EXPECT_EQ(read("\\hspace{1e9em}"), "error 1: `1e9em` is no length: write it as `2em` or `5pt`.");
  EXPECT_EQ(read("\\hspace{nanem}"), "error 1: `nanem` is no length: write it as `2em` or `5pt`.");
}

TEST(ReadLatexError, BytesThatAreNoUtf8_AreToldAtTheirColumn) {
  EXPECT_EQ(read("ab\xFF"), "error 3: This byte is no character: the text is not UTF-8.");
  EXPECT_EQ(read("\xC3"), "error 1: This byte is no character: the text is not UTF-8.");
  EXPECT_EQ(read("\xED\xA0\x80"), "error 1: This byte is no character: the text is not UTF-8.");
  EXPECT_EQ(read("\xC0\xAF"), "error 1: This byte is no character: the text is not UTF-8.");
  EXPECT_EQ(read(std::string_view("a\0", 2)), "error 2: This character cannot be shown.");
}

TEST(ReadLatexError, DeepNesting_IsRefusedInEveryForm) {
  for (const char *opener : {"{", "\\frac{", "\\vec ", "\\left(", "\\sqrt[", "x^{", "\\text{", "\\text{$",
                             "\\mark{a}{", "\\begin{matrix}", "\\substack{", "\\not", "a\\over "})
    EXPECT_NE(read(repeated(opener, 3000)).find("This is nested too deeply."), std::string::npos) << opener;
}

TEST(ReadLatexError, NestingUpToTheLimit_IsRead) {
  const int depth = deepestNesting / 2 - 2;
  EXPECT_EQ(read(repeated("\\sqrt{", depth) + "x" + repeated("}", depth)).find("error"), std::string::npos);
}

TEST(ReadLatexError, LongFormulas_AreRefused) {
  EXPECT_EQ(read(repeated("x", static_cast<int>(mostNodes) + 1)), "error 20001: This formula is too long.");
  EXPECT_EQ(read(repeated("x", static_cast<int>(longestLatex) + 1)), "error 1: This formula is too long.");
  EXPECT_EQ(read(repeated("x", static_cast<int>(mostNodes) - 1)).find("error"), std::string::npos);
}

TEST(ReadLatexError, InAnotherLanguage_SaysNothingInEnglish) {
  const test::SpokenToIn nobody(pseudoLanguage());
  const std::string deep(deepestNesting + 1, '{');
  for (const std::string latex :
       {"\\foo", "x^{2", "{x&y}", "a\\left(x", "\\begin{matrix}a", "\\begin{matrix}a\\end{pmatrix}",
        "\\begin{tikz}\\end{tikz}", "\\begin{array}{x}a\\end{array}", "\\begin{array}{}a\\end{array}",
        "\\begin", "\\substack a", "x^a^b", "\\frac1", "\\hspace{2}", "\xFF", deep.c_str()}) {
    const std::string told = read(latex);
    EXPECT_TRUE(told.starts_with("error")) << told;
    EXPECT_EQ(test::untranslatedIn(told, {"error"}), std::vector<std::string>()) << told;
  }
}

} // namespace
} // namespace halfspace::math
