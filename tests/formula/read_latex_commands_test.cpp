// The commands of LaTeX one by one: what each makes of what stands behind it.
#include "tests/formula/described.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halfspace::math {
namespace {

Row rowOf(std::string_view latex) {
  const auto result = readLatex(latex);
  EXPECT_TRUE(std::holds_alternative<Row>(result)) << latex;
  return std::holds_alternative<Row>(result) ? std::get<Row>(result) : Row();
}

/// The only atom of a formula, which is of this kind.
template <class Kind> Kind only(std::string_view latex) {
  const Row row = rowOf(latex);
  const Kind *content = row.size() == 1 ? std::get_if<Kind>(&row.front().content) : nullptr;
  EXPECT_TRUE(content) << latex;
  return content ? *content : Kind();
}

struct Length {
  const char *text;
  double em;
};

struct Lengths : testing::TestWithParam<Length> {};

TEST_P(Lengths, OfEveryUnit_AreTheSameWithAndWithoutBraces) {
  const std::string text = GetParam().text;
  EXPECT_NEAR(only<Space>("\\hspace{" + text + "}").width, GetParam().em, 1e-9);
  EXPECT_NEAR(only<Space>("\\hspace*{" + text + "}").width, GetParam().em, 1e-9);
  EXPECT_NEAR(only<Space>("\\kern" + text).width, GetParam().em, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Units, Lengths,
                         testing::Values(Length{"2em", 2}, Length{"-1.5em", -1.5}, Length{"10pt", 1},
                                         Length{"18mu", 1}, Length{"1ex", 0.431}, Length{"1cm", 2.845},
                                         Length{"10mm", 2.845}, Length{"1in", 7.227}, Length{"5px", 0.5},
                                         Length{".5em", 0.5}, Length{"+3em", 3}));

TEST(Commands, ForSpaces_AreAsWideAsTex) {
  const auto width = [](const std::string &name) { return only<Space>("\\" + name).width; };
  EXPECT_DOUBLE_EQ(width(","), 3.0 / 18);
  EXPECT_DOUBLE_EQ(width(":"), 4.0 / 18);
  EXPECT_DOUBLE_EQ(width(";"), 5.0 / 18);
  EXPECT_DOUBLE_EQ(width("!"), -width(","));
  EXPECT_DOUBLE_EQ(width("qquad"), 2);
}

TEST(Commands, ForALengthThatIsTooLong_AreRefused) {
  EXPECT_EQ(read("\\hspace{99em}"), "space(99)");
  EXPECT_EQ(read("\\kern101em"), "error 1: `101em` is no length: write it as `2em` or `5pt`.");
  EXPECT_EQ(read("a\\kern2"), "error 2: `2` is no length: write it as `2em` or `5pt`.");
}

TEST(Commands, ForColours_KnowNamesAndNumbers) {
  EXPECT_EQ((only<Colored>("\\color{orange}{x}").color), (Color{255, 128, 0}));
  EXPECT_EQ((only<Colored>("\\color{#0a0B0c}{x}").color), (Color{10, 11, 12}));
  for (const char *none : {"#12345", "#1234567", "#12345g", "Red", ""})
    EXPECT_EQ(read("\\color{" + std::string(none) + "}x").find("error 1: The colour"), 0U) << none;
}

struct Invisible {
  const char *command;
  bool isShown;
  bool keepsWidth;
  bool keepsHeight;
};

struct Phantoms : testing::TestWithParam<Invisible> {};

TEST_P(Phantoms, OfEveryName_KeepWhatTheySay) {
  const auto phantom = only<Phantom>("\\" + std::string(GetParam().command) + "{x}");
  EXPECT_EQ(phantom.isShown, GetParam().isShown);
  EXPECT_EQ(phantom.keepsWidth, GetParam().keepsWidth);
  EXPECT_EQ(phantom.keepsHeight, GetParam().keepsHeight);
}

INSTANTIATE_TEST_SUITE_P(Names, Phantoms,
                         testing::Values(Invisible{"phantom", false, true, true},
                                         Invisible{"vphantom", false, false, true},
                                         Invisible{"hphantom", false, true, false},
                                         Invisible{"smash", true, true, false},
                                         Invisible{"mathrlap", true, false, true}));

TEST(Commands, ForClasses_MakeAnythingOneAtomOfThem) {
  EXPECT_EQ(read("\\mathrel{ab}"), "{a b}:Rel");
  EXPECT_EQ(read("\\mathbin{+}\\mathopen|\\mathclose|"), "{+:Bin}:Bin {|}:Open {|}:Close");
  EXPECT_EQ(scriptPlaceOf(rowOf("\\mathop{X}")), ScriptPlace::LimitsInDisplay);
  EXPECT_EQ(scriptPlaceOf(rowOf("\\mathrel{X}")), ScriptPlace::Beside);
}

TEST(Commands, ForStacks_PutTheirFirstArgumentAboveOrBelow) {
  EXPECT_EQ(read("\\overset{a}{b}"), "stack(b|a|)");
  EXPECT_EQ(read("\\underset{a}{b}"), "stack(b||a)");
  EXPECT_EQ(read("\\stackrel{a}{b}"), "stack(b|a|):Rel") << "always a relation";
}

TEST(Commands, ForNegation_StrikeThroughWhatHasNoCharacterOfItsOwn) {
  EXPECT_EQ(read("\\not{ab}"), "not(a b)");
  EXPECT_EQ(read("\\not\\in"), "∉:Rel");
  EXPECT_EQ(read("\\not{}"), "not():Rel");
}

TEST(Commands, ForDots_LookAtWhatFollows) {
  const std::string onAxis = "{⋅:Punct ⋅:Punct ⋅:Punct}:Inner";
  EXPECT_EQ(read("\\dots="), onAxis + " =:Rel");
  EXPECT_EQ(read("\\dots\\times"), onAxis + " ×:Bin");
  EXPECT_EQ(read("\\dots").find(onAxis), std::string::npos);
  EXPECT_EQ(read("\\cdots,"), onAxis + " ,:Punct") << "these know where they stand";
  EXPECT_EQ(read("\\ddots"), "⋱:Inner");
}

TEST(Commands, ForFractionsOfOldTex_TakeTheWholeGroup) {
  EXPECT_EQ(read("x{a+b\\over c+d}y"), "x {frac(a +:Bin b|c +:Bin d)} y");
  EXPECT_EQ(read("{a\\atop b}"), "{over(a|b)}");
  EXPECT_EQ(read("\\left(a\\over b\\right)"), "fenced((|frac(a|b)|)):Inner");
}

TEST(Commands, ForContinuedFractions_KeepTheirNumeratorsTall) {
  EXPECT_EQ(read("\\cfrac{1}{x}"), "frac0(phantom(() 1|x)");
}

TEST(Commands, ForModulo_SetItApart) {
  EXPECT_EQ(read("a\\pmod n"), "a space(1) (:Open \"mod\" space(0.333) n ):Close");
}

TEST(Commands, ForNumbersOfFormulas_SetThemBehindInParentheses) {
  EXPECT_EQ(read("a\\tag{1}"), "a space(2) (:Open \"1\" ):Close");
  EXPECT_EQ(read("a\\label{eq:a}\\nonumber"), "a") << "a page's business";
}

TEST(Commands, ForBoxes_HaveTheirMeasures) {
  EXPECT_EQ(read("\\rule{1em}{5pt}"), "block(1|0.5)");
  EXPECT_EQ(read("\\rule{-1em}{5pt}"), "error 1: A box cannot be smaller than nothing.");
  EXPECT_EQ(read("\\rule 1"), "error 1: A `{` is missing behind this command.");
}

TEST(Commands, ForOperatorNames_HaveLimitsWithAStar) {
  EXPECT_EQ(scriptPlaceOf(rowOf("\\operatorname*{argmax}")), ScriptPlace::LimitsInDisplay);
  EXPECT_EQ(scriptPlaceOf(rowOf("\\operatorname{area}")), ScriptPlace::Beside);
  EXPECT_EQ(read("\\limsup"), "\"lim sup\":Op");
}

TEST(Words, InText_HaveQuotesSpacesAndSignsOfTheirOwn) {
  EXPECT_EQ(read("\\text{`so~it is'}"), "\"‘so it is’\"");
  EXPECT_EQ(read("\\text{\\{50\\%\\}}"), "\"{50%}\"");
  EXPECT_EQ(read("\\text{a\\quad b}"), "{\"a\" space(1) \"b\"}");
  EXPECT_EQ(read("\\text{a \\alpha b}"), "{\"a \" 𝛼 \"b\"}");
}

TEST(Words, WithAFormulaInside_GoBackToWords) {
  EXPECT_EQ(read("\\mathbf{\\text{$x$ is}}"), "{{x} \" is\"}") << "the alphabet ends at the words";
  EXPECT_EQ(read("\\text{if $x"), "error 10: A `$` is missing for this `$`.");
  EXPECT_EQ(read("\\text ab"), "error 1: The words are missing: put them into `{}`.");
}

TEST(Words, WithAnAlphabetSwitchedToInside_HaveItUpToTheEndOfTheGroup) {
  EXPECT_EQ(read("\\text{a\\bf b}C"), "{\"a\" \"b\"} C") << "not behind it";
  EXPECT_EQ(read("\\text{a{\\bf\\beta}\\beta}"), "{\"a\" 𝛃 𝛽}");
  std::vector<Alphabet> alphabets;
  for (const Node &node : only<Group>("\\text{a\\bf b{\\it c}d}").row)
    alphabets.push_back(std::get<Words>(node.content).alphabet);
  EXPECT_EQ(alphabets, (std::vector{Alphabet::Upright, Alphabet::Bold, Alphabet::Italic, Alphabet::Bold}));
}

TEST(Environments, OfEachKind_HaveTheirFencesAndColumns) {
  EXPECT_EQ(read("\\begin{rcases}a\\end{rcases}"), "fenced(.|table[a]|}):Inner");
  EXPECT_EQ(read("\\begin{bsmallmatrix}a\\end{bsmallmatrix}"), "fenced([|table[a]|]):Inner");
  EXPECT_EQ(only<Table>("\\begin{aligned}a&=b\\end{aligned}").columns,
            (std::vector{Align::Right, Align::Left}));
  EXPECT_EQ(only<Table>("\\begin{gathered}a\\end{gathered}").kind, TableKind::Gathered);
  EXPECT_EQ(only<Table>("\\substack{a\\\\b}").kind, TableKind::Stacked);
}

TEST(Environments, EndTheirRowsInEveryWay) {
  EXPECT_EQ(read("\\begin{matrix}a\\cr b\\\\*c\\\\\\end{matrix}"), "table[a][b][c]");
  EXPECT_EQ(read("\\begin{array}[t]{c}\\hline a\\end{array}"), "table[-a]")
      << "where it stands is ours to say";
  EXPECT_EQ(read("\\begin{matrix}a\\\\[9]b\\end{matrix}"),
            "error 16: `9` is no length: write it as `2em` or `5pt`.");
}

TEST(Environments, WithAnAlphabetInACell_HaveItThereAlone) {
  EXPECT_EQ(read("\\begin{matrix}\\bf A&B\\end{matrix}C"), "table[𝐀 & B] C");
}

TEST(Environments, WithBracketsInACell_DoNotEndAnOptionAroundThem) {
  EXPECT_EQ(read("\\sqrt[\\begin{matrix}[a]\\end{matrix}]{x}"), "root(x|table[[:Open a ]:Close])");
}

TEST(Environments, OfNoColumns_AreRefused) {
  for (const char *columns : {"{}", "{||}", "{lx}"})
    EXPECT_EQ(read("\\begin{array}" + std::string(columns) + "a\\end{array}"),
              "error 14: A table's columns are `l`, `c` and `r`, with `|` for a rule.");
}

} // namespace
} // namespace halfspace::math
