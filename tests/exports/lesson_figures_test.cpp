// Every step of every lesson in every format; what other programs find in the files.
#include "lessons/lesson/lesson_start.h"
#include "lessons/scene/file/session_file.h"
#include "tests/effort.h"
#include "tests/exports/lesson_drawings.h"
#include "tests/program_test.h"
#include "widgets/carriers/found_session.h"
#include "widgets/exports/format.h"
#include "widgets/exports/pdf_writer.h"
#include "widgets/exports/qr_beside.h"
#include "widgets/exports/svg_writer.h"
#include "widgets/exports/tikz_writer.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

namespace halfspace {
namespace {

/// A step of a lesson, as a figure.
struct StepFigure {
  std::string name;
  const Lesson *lesson = nullptr;
  const LessonStep *step = nullptr;
};

/// Those of all lessons; where each step is watched, some of them.
std::vector<StepFigure> stepFigures() {
  std::vector<StepFigure> figures;
  for (const Lesson &lesson : library().lessons)
    for (std::size_t i = 0; i < lesson.steps.size(); ++i)
      figures.push_back({lesson.id + "-" + std::to_string(i + 1), &lesson, &lesson.steps[i]});
  return test::fewer(figures);
}

class LessonFigures : public ProgramTest {
protected:
  template <class Visit> void forEachStep(Visit visit) const {
    for (const StepFigure &figure : stepFigures()) {
      SCOPED_TRACE(figure.name);
      visit(figure.name, drawingOfStep(*figure.lesson, *figure.step));
    }
  }
};

TEST_F(LessonFigures, InEveryFormat_AreTheSameBytesAgain_WithoutAPictureOfPixels) {
  forEachStep([](const std::string &, const Drawing &drawing) {
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

TEST_F(LessonFigures, HaveFiniteNumbersAlone) {
  forEachStep([](const std::string &, const Drawing &drawing) {
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

/// The marks that a list of shapes is of.
std::set<std::string> marksOf(const ShapeList &shapes) {
  std::set<std::string> marks;
  for (const ShapeLayer &layer : shapes.layers)
    for (const Shape &shape : *layer)
      marks.insert(shape.mark);
  marks.erase(""); // axes and the ground
  return marks;
}

TEST_F(LessonFigures, HaveAPartForEachMarkOfTheirPicture) {
  for (const StepFigure &figure : stepFigures()) {
    SCOPED_TRACE(figure.name);
    const PaperLook look;
    const Theme &theme = *findTheme("print");
    const ShapeList shapes =
        shapesOfStep(*figure.lesson, figure.step, viewOnPaper({1600, 1000}, look.width, 9, theme), theme);
    std::set<std::string> drawn;
    for (const DrawingPart &part : drawingOf(shapes, look).parts)
      drawn.insert(std::visit([](const auto &one) { return one.mark; }, part));
    for (const std::string &mark : marksOf(shapes))
      EXPECT_TRUE(drawn.contains(mark)) << mark;
  }
}

TEST_F(LessonFigures, AsSvg_AreWellFormed) {
  if (!has("xmllint"))
    GTEST_SKIP() << "xmllint is not installed";
  forEachStep([&](const std::string &name, const Drawing &drawing) {
    write(name + "-shapes.svg", svgOf(drawing, math::fonts(), TextAs::Shapes));
    write(name + "-letters.svg", svgOf(drawing, math::fonts(), TextAs::Letters));
  });
  const Ran ran = shell("xmllint --noout *.svg >.out 2>.err");
  EXPECT_EQ(ran.status, 0) << ran.err;
}

/// The formulas of a drawing, one behind the other, without spaces.
std::string formulasOf(const Drawing &drawing) {
  std::string formulas;
  for (const DrawingPart &part : drawing.parts)
    if (const auto *formula = std::get_if<FormulaPart>(&part))
      formulas += formula->plain;
  formulas.erase(std::remove(formulas.begin(), formulas.end(), ' '), formulas.end());
  return formulas;
}

TEST_F(LessonFigures, AsPdf_AreWithoutFault_AndTheirTextsAreThoseOfTheFormulas) {
  if (!has("qpdf pdftotext"))
    GTEST_SKIP() << "qpdf or pdftotext is not installed";
  std::map<std::string, std::string> formulas; // in the order in which a shell names the files
  forEachStep([&](const std::string &name, const Drawing &drawing) {
    write(name + ".pdf", pdfOf(drawing, math::fonts()));
    formulas[name + ".pdf"] = formulasOf(drawing);
  });
  const Ran merged = shell("export LC_ALL=C; qpdf --empty --pages *.pdf -- merged >.out 2>.err");
  EXPECT_EQ(merged.status, 0) << merged.err; // 3: it has repaired what it warns of
  // One formula after the other: where two stand in one row, both are in one line.
  std::string found = shell("pdftotext -raw merged - >.out 2>.err").out;
  found.erase(std::remove_if(found.begin(), found.end(),
                             [](unsigned char c) { return std::isspace(c) && c != '\f'; }),
              found.end());
  std::istringstream pages(found);
  for (const auto &[name, expected] : formulas) {
    std::string page;
    std::getline(pages, page, '\f');
    EXPECT_EQ(page, expected) << name;
  }
}

TEST_F(LessonFigures, AsTikz_AreTakenByLatex) {
  if (!has("pdflatex kpsewhich") || shell("kpsewhich tikz.sty >.out 2>.err").status != 0)
    GTEST_SKIP() << "LaTeX with TikZ is not installed";
  std::string document = "\\documentclass{article}\n\\usepackage{fix-cm,amsmath,tikz}\n\\begin{document}\n";
  // A second a figure: the last of each lesson, which shows most of it.
  for (const Lesson &lesson : library().lessons) {
    write(lesson.id + ".tex", tikzOf(drawingOfStep(lesson, lesson.steps.back())));
    document += "\\input{" + lesson.id + "}\n\n";
  }
  write("all.tex", document + "\\end{document}\n");
  // Each alone is a document too.
  const std::string first = library().lessons.front().id;
  for (const std::string &name : {std::string("all"), first}) {
    const Ran ran = shell("pdflatex -interaction=nonstopmode -halt-on-error " + name + ".tex >.out 2>.err");
    EXPECT_EQ(ran.status, 0) << ran.out.substr(ran.out.size() - std::min<std::size_t>(ran.out.size(), 2000));
  }
}

TEST_F(LessonFigures, WithTheirCode_AreReadAsOtherProgramsDrawThem) {
  if (!has("rsvg-convert pdftoppm"))
    GTEST_SKIP() << "rsvg-convert or pdftoppm is not installed";
  constexpr std::size_t oneIn = 5; // a second a figure
  for (std::size_t i = 0; i < library().lessons.size(); i += oneIn) {
    const Lesson &lesson = library().lessons[i];
    const std::string session = writeSession(startOf(lesson));
    const Drawing drawing = withQrCode(drawingOfStep(lesson, lesson.steps.back()), *qrCodeOf(session));
    write("figure.svg", svgOf(drawing, math::fonts()));
    write("figure.pdf", pdfOf(drawing, math::fonts()));
    for (const char *program : {"rsvg-convert --zoom 2 figure.svg -o figure.png",
                                "pdftoppm -r 200 -png -singlefile figure.pdf figure"}) {
      SCOPED_TRACE(lesson.id + ": " + program);
      std::filesystem::remove(inFolder("figure.png"));
      const Ran ran = shell(std::string(program) + " >.out 2>.err");
      EXPECT_EQ(ran.status, 0) << ran.err;
      const auto found = findSession(inFolder("figure.png"));
      ASSERT_TRUE(found) << found.problem().sentence;
      EXPECT_EQ(found->text, session);
    }
  }
}

using TikzLabel = ProgramTest;

TEST_F(TikzLabel, OnItsHalo_IsInThePdfOnce_WithTheColonAtItsLetter) {
  const std::string tools = "command -v pdflatex && command -v pdftotext && kpsewhich tikz.sty";
  if (shell("{ " + tools + "; } >.out 2>.err").status != 0)
    GTEST_SKIP() << "LaTeX with TikZ or pdftotext is not installed";
  FormulaPart label;
  label.latex = "E\\colon\\ {x = 14}";
  label.formula = vectorsOnly()(label.latex);
  label.start = {20, 20};
  label.size = 9;
  label.opacity = 0.5;
  write("figure.tex", tikzOf({{120, 40}, {}, {label}}));
  const Ran ran = shell("pdflatex -interaction=nonstopmode -halt-on-error figure.tex >.out 2>.err");
  ASSERT_EQ(ran.status, 0) << ran.out;
  EXPECT_EQ(shell("pdftotext figure.pdf - >.out 2>.err").out.substr(0, 10), "E: x = 14\n");
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
