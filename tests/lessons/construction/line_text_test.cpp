#include "lessons/construction/line_text.h"

#include "lessons/construction/parts/worked_lines.h"
#include "tests/effort.h"
#include "tests/lessons/construction/random_objects.h"
#include "tests/lessons/scenes.h"
#include "tests/lessons/spoken_to_in.h"
#include "tests/lessons/term/read_mathml.h"

#include <gtest/gtest.h>

#include <functional>

namespace halfspace {
namespace {

using namespace test;

const Term f = name(letter("f"), Rational(30));
const Term d = name(letter("d"), Rational(10));
const WorkingLine quotient = line(withNumbers(d == f / 3), "It is < 1 & 100 % so.");
const WorkingLine both = [] {
  WorkingLine line{"both", {}};
  line.chains = {withResult(f), withResult(d)};
  return line;
}();

/// Every line of every construction, in scenes of all kinds of numbers.
void forEveryLine(const std::function<void(const WorkingLine &)> &look) {
  constexpr int scenesPerWriting = effort(3);
  RandomObjects random(29);
  for (const Construction &construction : constructions())
    for (const Writing writing : {Writing::SmallIntegers, Writing::Halves, Writing::Decimals,
                                  Writing::Fractions, Writing::LongFractions, Writing::LargeIntegers})
      for (int i = 0; i < scenesPerWriting; ++i) {
        const Evaluation outcome = evaluate(sceneOf(construction, random.objectsFor(construction, writing)));
        const Explanation &explanation = *outcome.entries.back().outcome->explanation;
        for (const std::string &id : explanation.ids())
          look(*explanation.find(id));
      }
}

/// How many parentheses open in LaTeX, those of matrices among them.
std::size_t openedIn(const std::string &latex) {
  std::size_t count = 0;
  for (const std::string_view opening : {"(", "\\begin{pmatrix}"})
    for (auto at = latex.find(opening); at != std::string::npos; at = latex.find(opening, at + 1))
      ++count;
  return count;
}

std::size_t openedInMathMl(const std::string &math) {
  std::size_t count = 0;
  for (auto at = math.find("<mo>(</mo>"); at != std::string::npos; at = math.find("<mo>(</mo>", at + 1))
    ++count;
  return count;
}

TEST(FormulaText, OfALine_HasNoSentence) {
  EXPECT_EQ(formulaText({&quotient}, DocumentFormat::Latex), "d = \\frac{f}{3} = \\frac{30}{3} = 10");
  EXPECT_EQ(formulaText({&quotient}, DocumentFormat::PlainText), "d = f/3 = 30/3 = 10");
  EXPECT_EQ(formulaText({&quotient}, DocumentFormat::MathMl),
            "<math xmlns=\"http://www.w3.org/1998/Math/MathML\" display=\"block\"><mrow><mi>d</mi><mo>=</mo>"
            "<mfrac><mi>f</mi><mn>3</mn></mfrac><mo>=</mo><mfrac><mn>30</mn><mn>3</mn></mfrac><mo>=</mo>"
            "<mn>10</mn></mrow></math>");
}

TEST(FormulaText, OfSeveralStatements_PartsThemByCommas) {
  EXPECT_EQ(formulaText({&both}, DocumentFormat::Latex), "f = 30,\\quad d = 10");
  EXPECT_EQ(formulaText({&both}, DocumentFormat::PlainText), "f = 30, d = 10");
  EXPECT_EQ(plainMathMl(formulaText({&both}, DocumentFormat::MathMl)), "f=30,d=10");
}

TEST(FormulaText, OfALineThatIsNotWhole_KeepsItsNumbersBack) {
  EXPECT_EQ(formulaText({&quotient, false}, DocumentFormat::Latex), "d = \\frac{f}{3}");
  EXPECT_EQ(formulaText({&quotient, false}, DocumentFormat::PlainText), "d = f/3");
  EXPECT_EQ(plainMathMl(formulaText({&quotient, false}, DocumentFormat::MathMl)), "d=f/3");
  EXPECT_EQ(formulaText({&both, false}, DocumentFormat::Latex), "f,\\quad d");
}

TEST(FormulaText, OfMarks_CarriesNoIds) {
  const WorkingLine marked = line(withResult(f.marked("distance.f")));
  for (const DocumentFormat format :
       {DocumentFormat::Latex, DocumentFormat::MathMl, DocumentFormat::PlainText})
    EXPECT_EQ(formulaText({&marked}, format).find("distance.f"), std::string::npos);
}

TEST(WorkingText, HasTheWordsBesideTheLinesAsText) {
  const std::vector<ToldLine> lines{{&quotient}, {&both}, {&quotient}};
  EXPECT_EQ(workingText(lines, DocumentFormat::Latex), "\\begin{align*}\n"
                                                       "  d &= \\frac{f}{3} = \\frac{30}{3} = 10 \\\\\n"
                                                       "\\intertext{It is < 1 \\& 100 \\% so.}\n"
                                                       "  f &= 30,\\quad d = 10 \\\\\n"
                                                       "  d &= \\frac{f}{3} = \\frac{30}{3} = 10\n"
                                                       "\\end{align*}\n"
                                                       "It is < 1 \\& 100 \\% so.\n");
  EXPECT_EQ(workingText(lines, DocumentFormat::PlainText), "d = f/3 = 30/3 = 10\n"
                                                           "    It is < 1 & 100 % so.\n"
                                                           "f = 30, d = 10\n"
                                                           "d = f/3 = 30/3 = 10\n"
                                                           "    It is < 1 & 100 % so.\n");
  EXPECT_EQ(workingText({{&quotient}}, DocumentFormat::MathMl),
            "<p>" + formulaText({&quotient}, DocumentFormat::MathMl) +
                "</p>\n<p>It is &lt; 1 &amp; 100 % so.</p>\n");
}

TEST(WorkingText, OfALineThatIsNotWhole_KeepsItsSentenceBack) {
  for (const DocumentFormat format :
       {DocumentFormat::Latex, DocumentFormat::MathMl, DocumentFormat::PlainText}) {
    const std::string text = workingText({{&quotient, false}, {&both}}, format);
    EXPECT_EQ(text.find("It is"), std::string::npos) << text;
    EXPECT_EQ(text.find("30/3"), std::string::npos) << text;
  }
  EXPECT_EQ(workingText({{&both, false}}, DocumentFormat::Latex),
            "\\begin{align*}\n  f,\\quad d &\n\\end{align*}\n");
}

TEST(WorkingText, OfNoLines_IsEmpty) {
  for (const DocumentFormat format :
       {DocumentFormat::Latex, DocumentFormat::MathMl, DocumentFormat::PlainText})
    EXPECT_EQ(workingText({}, format), "");
}

TEST(FormulaText, InMathMlOfEveryLine_SaysWhatPlainTextSays) {
  forEveryLine([](const WorkingLine &line) {
    EXPECT_EQ(plainMathMl(formulaText({&line}, DocumentFormat::MathMl)), withoutGrouping(plainText(line)))
        << line.id;
  });
}

TEST(FormulaText, InMathMlWithADecimalComma_SaysWhatPlainTextSays) {
  const SpokenToIn language(withDecimalComma());
  forEveryLine([](const WorkingLine &line) {
    EXPECT_EQ(plainMathMl(formulaText({&line}, DocumentFormat::MathMl)), withoutGrouping(plainText(line)))
        << line.id;
  });
}

TEST(FormulaText, InMathMlOfEveryLine_GroupsAsLatexDoes) {
  forEveryLine([](const WorkingLine &line) {
    const std::string latex = formulaText({&line}, DocumentFormat::Latex);
    const std::string math = formulaText({&line}, DocumentFormat::MathMl);
    EXPECT_EQ(openedInMathMl(math), openedIn(latex)) << latex << "\n" << math;
  });
}

} // namespace
} // namespace halfspace
