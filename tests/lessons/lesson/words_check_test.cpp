#include "lessons/lesson/words_check.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using Texts = std::vector<std::string>;

/// The problems of a lesson of one step with these words, as `line: sentence`; their first line is 1.
Texts problemsIn(const std::string &words) {
  constexpr int linesBefore = 7;
  const auto lesson = parseLesson(
      "---\nid: example\ntitle: An example\nscene:\n  - {name: Q, point: [1, 2, 3]}\n---\n## One\n" + words,
      "a.md");
  EXPECT_TRUE(lesson) << lesson.problem().text();
  Texts texts;
  if (lesson)
    for (const Problem &problem : problemsWithWords(*lesson))
      texts.push_back(std::to_string(problem.line - linesBefore) + ": " + problem.sentence);
  return texts;
}

std::string noStep(int line, const std::string &title) {
  return std::to_string(line) + ": This heading begins no step. Perhaps “## " + title + "” is meant.";
}

std::string loneDollar(int line) {
  return std::to_string(line) + ": This $ has no partner in its paragraph. End the formula with another, "
                                "without a space before it, or write \\$ for a dollar.";
}

TEST(WordsCheck, HeadingThatBeginsNoStep_IsTold) {
  EXPECT_EQ(problemsIn("Words\n\n# Guess\n"), Texts{noStep(3, "Guess")});
  EXPECT_EQ(problemsIn("##Guess\nWords\n#Look\n"), (Texts{noStep(1, "Guess"), noStep(3, "Look")}));
  EXPECT_EQ(problemsIn("```note\nTitle\nWords\n```\n\n ## Guess\n"), Texts{noStep(6, "Guess")});
}

TEST(WordsCheck, HeadingsWithinAStep_CodeAndNumbers_AreRight) {
  EXPECT_EQ(problemsIn("### Smaller\n#1 is the first, # and ##\n#\n##\n\n    # code\n"), Texts{});
  EXPECT_EQ(problemsIn("~~~note\nTitle\n# A heading\n~~~\n"), Texts{});
  EXPECT_EQ(problemsIn("```python\n# a comment\n```\n~~~\n## another\n~~~\n"), Texts{});
}

TEST(WordsCheck, BlockThatIsNearlyAnInstruction_IsTold_InNotesToo) {
  const std::string sentence = ": There is no block “tusk”. Perhaps “task” is meant.";
  EXPECT_EQ(problemsIn("Words\n```tusk\ndo: x\n```\n"), Texts{"2" + sentence});
  EXPECT_EQ(problemsIn("~~~note\nTitle\n```tusk\ndo: x\n```\n~~~\n"), Texts{"3" + sentence});
}

TEST(WordsCheck, DollarWithoutAPartner_IsToldOnceAParagraph) {
  EXPECT_EQ(problemsIn("So $x is it\n\nand $y$.\n"), Texts{loneDollar(1)});
  EXPECT_EQ(problemsIn("A $x $ with a space\n\nand\n$$y\n"), (Texts{loneDollar(1), loneDollar(4)}));
  EXPECT_EQ(problemsIn("It costs \\$5, `$x` and $x$ and $$y$$\n\n```\n$code\n```\n"), Texts{});
}

/// The problems of a question whose words are this YAML.
Texts problemsInQuestion(const std::string &yaml) {
  return problemsIn("```predict\nask: " + yaml +
                    "\nchoices:\n  yes: Yes\n  no: No\nanswer: x\nwhy: So\n```\n");
}

TEST(WordsCheck, LatexThatDoubleQuotesReadAsYaml_IsTold) {
  const Texts told{
      "2: In double quotes a backslash begins a sign of YAML's own: put the text in single quotes."};
  for (const char *latex : {"\\theta", "\\frac12", "\\vec n", "\\rho", "\\nu", "\\nu_1", "a \\neq b",
                            "2\\nu + \\nu", "a \\ne b", "\\neg a", "\\nabla f", "\\Lambda", "a\\Pi"})
    EXPECT_EQ(problemsInQuestion("\"Is it $" + std::string(latex) + "$?\""), told) << latex;
}

TEST(WordsCheck, LatexInOtherWords_IsRight) {
  EXPECT_EQ(problemsInQuestion("'Is it $\\nu \\neq \\theta$?'"), Texts{});
  EXPECT_EQ(problemsInQuestion("\"Is it $a$\\nor $b$,\\n\\nor $c$?\""), Texts{});
  EXPECT_EQ(problemsInQuestion("\"So:\\n\\n$$\\nx = 1\\n$$\\n\\nIs it $a$?\""), Texts{});
  EXPECT_EQ(problemsInQuestion("|\n  Is it $s +\n  u$, not\n  eqal?"), Texts{});
}

TEST(WordsCheck, LatexThatDoubleQuotesRefuse_IsTold) {
  for (const char *latex : {"\\xi", "\\underline{a}", "\\Upsilon", "\\lambda"}) {
    const auto lesson = parseLesson(
        "---\nid: example\ntitle: \"" + std::string(latex) + "\"\nscene: []\n---\n## One\n", "a.md");
    ASSERT_FALSE(lesson) << latex;
    EXPECT_NE(lesson.problem().sentence.find("single quotes"), std::string::npos) << lesson.problem().text();
  }
}

} // namespace
} // namespace halfspace
