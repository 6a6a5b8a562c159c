// Every step of every lesson in every format; what other programs find in the files.
#include "lessons/lesson/lesson_start.h"
#include "lessons/scene/file/session_file.h"
#include "tests/exports/lesson_drawings.h"
#include "tests/program_test.h"
#include "tests/test_name.h"
#include "widgets/carriers/found_session.h"
#include "widgets/exports/format.h"
#include "widgets/exports/pdf_writer.h"
#include "widgets/exports/qr_beside.h"
#include "widgets/exports/svg_writer.h"
#include "widgets/exports/tikz_writer.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace halfspace {
namespace {

std::vector<std::string> lessonIds() {
  std::vector<std::string> ids;
  for (const Lesson &lesson : library().lessons)
    ids.push_back(lesson.id);
  return ids;
}

class LessonFigures : public ProgramTest, public testing::WithParamInterface<std::string> {
protected:
  /// Whether a program is installed.
  [[nodiscard]] bool has(const std::string &program) const {
    return shell("command -v " + program + " >.out 2>.err").status == 0;
  }
  template <class Visit> void forEachStep(Visit visit) const {
    const Lesson &lesson = *library().find(GetParam());
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
      SCOPED_TRACE(lesson.steps[i].title);
      visit(drawingOfStep(lesson, lesson.steps[i]));
    }
  }
};
INSTANTIATE_TEST_SUITE_P(All, LessonFigures, testing::ValuesIn(lessonIds()), test::testName);

TEST_P(LessonFigures, InEveryFormat_AreTheSameBytesAgain_WithoutAPictureOfPixels) {
  forEachStep([](const Drawing &drawing) {
    EXPECT_GT(drawing.parts.size(), 20U);
    for (const ExportFormat &format : exportFormats()) {
      const std::string file = format.write(drawing, math::fonts(), TextAs::Shapes);
      EXPECT_EQ(file, format.write(drawing, math::fonts(), TextAs::Shapes)) << format.name;
      for (const char *pixels : {"<image", "/Subtype/Image", "includegraphics"})
        EXPECT_EQ(file.find(pixels), std::string::npos) << format.name << ": " << pixels;
      EXPECT_LT(file.size(), format.name == "PDF" ? 40U * 1024 : 1024U * 1024) << format.name;
    }
  });
}

TEST_P(LessonFigures, HaveFiniteNumbersAlone) {
  forEachStep([](const Drawing &drawing) {
    for (const DrawingPart &part : drawing.parts) {
      const auto *path = std::get_if<PathPart>(&part);
      if (!path)
        continue;
      for (const PageStep &step : path->path.steps)
        for (const glm::dvec2 spot : {step.to, step.first, step.second})
          EXPECT_TRUE(std::isfinite(spot.x) && std::isfinite(spot.y)) << path->mark;
      const Pen pen = path->pen.value_or(Pen());
      EXPECT_TRUE(std::isfinite(pen.width) && std::isfinite(pen.dashStart)) << path->mark;
    }
  });
}

TEST_P(LessonFigures, AsSvg_AreWellFormed) {
  if (!has("xmllint"))
    GTEST_SKIP() << "xmllint is not installed";
  forEachStep([&](const Drawing &drawing) {
    for (const TextAs text : {TextAs::Shapes, TextAs::Letters}) {
      write("figure.svg", svgOf(drawing, math::fonts(), text));
      const Ran ran = shell("xmllint --noout figure.svg >.out 2>.err");
      EXPECT_EQ(ran.status, 0) << ran.err;
    }
  });
}

TEST_P(LessonFigures, AsPdf_AreWithoutFault_AndTheirTextsAreThoseOfTheFormulas) {
  if (!has("qpdf") || !has("pdftotext"))
    GTEST_SKIP() << "qpdf or pdftotext is not installed";
  forEachStep([&](const Drawing &drawing) {
    write("figure.pdf", pdfOf(drawing, math::fonts()));
    const Ran checked = shell("qpdf --check figure.pdf >.out 2>.err");
    EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
    // One formula after the other: where two stand in one row, both are in one line.
    const Ran text = shell("pdftotext -raw figure.pdf - >.out 2>.err");
    std::string found = text.out;
    found.erase(std::remove_if(found.begin(), found.end(),
                               [](unsigned char c) { return std::isspace(c) || c == '\f'; }),
                found.end());
    std::string expected;
    for (const DrawingPart &part : drawing.parts)
      if (const auto *formula = std::get_if<FormulaPart>(&part))
        expected += formula->plain;
    expected.erase(std::remove(expected.begin(), expected.end(), ' '), expected.end());
    EXPECT_EQ(found, expected);
  });
}

TEST_P(LessonFigures, AsTikz_AreTakenByLatex) {
  if (!has("pdflatex") || !has("kpsewhich") || shell("kpsewhich tikz.sty >.out 2>.err").status != 0)
    GTEST_SKIP() << "LaTeX with TikZ is not installed";
  const Lesson &lesson = *library().find(GetParam());
  write("figure.tex", tikzOf(drawingOfStep(lesson, lesson.steps.back())));
  const Ran ran = shell("pdflatex -interaction=nonstopmode -halt-on-error figure.tex >.out 2>.err");
  EXPECT_EQ(ran.status, 0) << ran.out.substr(ran.out.size() - std::min<std::size_t>(ran.out.size(), 2000));
}

TEST_P(LessonFigures, WithTheirCode_AreReadAsOtherProgramsDrawThem) {
  if (!has("rsvg-convert") || !has("pdftoppm"))
    GTEST_SKIP() << "rsvg-convert or pdftoppm is not installed";
  const Lesson &lesson = *library().find(GetParam());
  const std::string session = writeSession(startOf(lesson));
  const Drawing drawing = withQrCode(drawingOfStep(lesson, lesson.steps.back()), *qrCodeOf(session));
  write("figure.svg", svgOf(drawing, math::fonts()));
  write("figure.pdf", pdfOf(drawing, math::fonts()));
  for (const char *program : {"rsvg-convert --zoom 2 figure.svg -o figure.png",
                              "pdftoppm -r 200 -png -singlefile figure.pdf figure"}) {
    SCOPED_TRACE(program);
    std::filesystem::remove(inFolder("figure.png"));
    const Ran ran = shell(std::string(program) + " >.out 2>.err");
    EXPECT_EQ(ran.status, 0) << ran.err;
    const auto found = findSession(inFolder("figure.png"));
    ASSERT_TRUE(found) << found.problem().sentence;
    EXPECT_EQ(found->text, session);
  }
}

TEST(FormatOfFile, GoesByTheEnding_WhateverItsCase) {
  EXPECT_EQ(formatOfFile("x.svg")->name, "SVG");
  EXPECT_EQ(formatOfFile("a/x.PDF")->name, "PDF");
  EXPECT_EQ(formatOfFile("x.tex")->name, "TikZ");
  EXPECT_EQ(formatOfFile("x.doc"), nullptr);
  EXPECT_EQ(formatOfFile("pdf"), nullptr);
}

} // namespace
} // namespace halfspace
