// What is exported as LaTeX, through pdflatex where that is installed.
#include "lessons/lesson/lesson.h"
#include "lessons/scene/file/explain_formats.h"
#include "lessons/scene/session.h"
#include "tests/lessons/construction/random_objects.h"
#include "tests/program_test.h"

#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

class PdfLatex : public ProgramTest {
protected:
  void SetUp() override {
    ProgramTest::SetUp();
    if (!has("pdflatex"))
      GTEST_SKIP() << "pdflatex is not installed";
  }

  /// The last lines that pdflatex says about a document, or nothing where all is well.
  std::string complaintAbout(const std::string &body) const {
    write("all.tex", "\\documentclass{article}\n\\usepackage{amsmath}\n\\begin{document}\n" + body +
                         "\n\\end{document}\n");
    const Ran ran = shell(
        "TEXMFVAR=\"$PWD\" pdflatex -interaction=nonstopmode -halt-on-error all.tex </dev/null >.out 2>.err");
    const auto error = ran.out.find("\n!");
    const bool lacksCharacters =
        contentOf(inFolder("all.log")).find("Missing character") != std::string::npos;
    if (ran.status == 0 && std::filesystem::exists(inFolder("all.pdf")) && !lacksCharacters)
      return {};
    return error == std::string::npos ? "characters are missing" : ran.out.substr(error);
  }
};

TEST_F(PdfLatex, OfOurLessons_IsSatisfied) {
  std::string body;
  for (const Lesson &lesson : readLessons(LESSON_FOLDER).lessons)
    body += explanationLatex(lesson.title, evaluate(lesson.scene));
  EXPECT_EQ(complaintAbout(body), "");
}

TEST_F(PdfLatex, OfRandomAndDegenerateScenes_IsSatisfied) {
  constexpr int scenesPerWriting = 12;
  RandomObjects random(11);
  std::string body;
  for (const Construction &construction : constructions())
    for (const Writing writing : {Writing::SmallIntegers, Writing::Halves, Writing::Decimals,
                                  Writing::Fractions, Writing::LongFractions, Writing::LargeIntegers})
      for (int i = 0; i < scenesPerWriting; ++i) {
        const Scene scene = sceneOf(construction, random.objectsFor(construction, writing));
        body += explanationLatex("Scene", evaluate(scene));
      }
  EXPECT_EQ(complaintAbout(body), "");
}

TEST_F(PdfLatex, OfTitlesInAnyLetters_IsSatisfied) {
  const Evaluation outcome = evaluate(readLessons(LESSON_FOLDER).lessons.front().scene);
  std::string body;
  for (const char *title :
       {"50 % of {a}_b^c & #1 ~ \\x $y$ <|>\"", "Größe “é” – ½ … ‘ñ’ œuvre", "α β γ Ω Δ λ θ φ → ⇒ ∈ ′ ⊥ ≤ √2",
        "ℝ³, плоскость, 平面, مستوى, 🙂, e\xCC\x81", "[x] % not a comment"})
    body += explanationLatex(title, outcome);
  EXPECT_EQ(complaintAbout(body), "");
}

} // namespace
} // namespace halfspace
