// Figures of every step of every lesson, made one after the other in every format; and what independent
// programs see in them.
#include "app/figures/figure_maker.h"
#include "lessons/lesson/lesson_start.h"
#include "lessons/lesson/shown.h"
#include "lessons/scene/file/session_file.h"
#include "tests/likeness.h"
#include "tests/program_test.h"
#include "widgets/carriers/carrier.h"
#include "widgets/picture/design_scale.h"
#include "widgets/picture/lesson_picture.h"
#include "widgets/typeset/label_painter.h"
#include "widgets/typeset/typesetter.h"

#include <QImage>

namespace halfspace {
namespace {

/// Of all pictures that are compared. Smaller ones do not show small marks any more.
constexpr PixelSize compared{480, 300};
/// Programs that draw vectors differ at edges, and in how they smooth letters: in patches of a few pixels.
constexpr test::Nearby sameVectors{test::Compared::Colours, 1, 20};
constexpr std::size_t largestOfVectors = 40;
/// Tubes are lit, and twice as thick as pens; heads of arrows are three times as large.
constexpr test::Nearby sameMarks{test::Compared::Hues, 4, 15};
constexpr std::size_t largestOfMarks = 220;
/// A mark that takes so many pixels among the vectors is missed where it lacks.
constexpr std::size_t leastMissed = 150;

const LessonLibrary &library() {
  static const LessonLibrary lessons = readLessons(TEST_LESSONS_FOLDER);
  return lessons;
}

/// One for all tests: what takes time to be opened serves all figures.
FigureMaker &maker() {
  static const Typesetter typesetter;
  static FigureMaker figures(typesetter);
  return figures;
}

FigureChoices choicesFor(const FigureFormat &format) {
  FigureChoices choices;
  choices.format = &format;
  choices.size = compared;
  choices.paper = PaperSize();
  choices.paper->pixelsPerInch = compared.width / (choices.paper->width / 72);
  choices.theme = *findTheme("print");
  return choices;
}

FigureChoices choicesFor(const std::string &ending) { return choicesFor(*figureFormatOf("figure" + ending)); }

/// What a step shows; null: all of the lesson.
FigureSubject subjectOf(const Lesson &lesson, const LessonStep *step) {
  const Evaluation evaluation = evaluate(lesson.scene);
  const Stage stage = stageOf(lesson.scene, boundObjectsOf(lesson.scene, evaluation));
  FigureSubject subject;
  subject.content = contentOf(&lesson, step, evaluation, stage);
  subject.camera = homeOf(&lesson, evaluation, stage, compared, ownPixelRatio(compared));
  subject.title = lesson.title;
  if (step)
    subject.description = shownIn(*step, evaluation).description;
  Session session = startOf(lesson);
  session.step = step ? static_cast<int>(step - lesson.steps.data()) : 0;
  subject.session = writeSession(session);
  return subject;
}

class StepFigures : public ProgramTest {
protected:
  [[nodiscard]] bool canBeLookedAt() const { return has("rsvg-convert pdftoppm qpdf"); }
  void make(const std::string &name, const std::string &ending, const FigureSubject &subject,
            const FigureChoices &choices) const {
    const auto figure = maker().file(subject, choices);
    ASSERT_TRUE(figure) << figure.problem().text();
    write(name + ending, figure->content);
  }
  /// Draws all SVG files of the folder as name.svg.png.
  void drawSvgs() const {
    const Ran ran =
        shell("for file in *.svg; do rsvg-convert -w " + std::to_string(compared.width) + " -h " +
              std::to_string(compared.height) + " -b white $file -o $file.png; done >.out 2>.err");
    EXPECT_EQ(ran.err, "");
  }
  /// Draws all PDF files of the folder as pages-1.ppm and so on, in the order of their names.
  void drawPdfs() const {
    const Ran ran = shell("(qpdf --empty --pages *.pdf -- pages.merged && pdftoppm -scale-to-x " +
                          std::to_string(compared.width) + " -scale-to-y " + std::to_string(compared.height) +
                          " pages.merged pages) >.out 2>.err");
    EXPECT_EQ(ran.out + ran.err, "");
  }
  [[nodiscard]] RgbaImage picture(const std::string &name) const {
    return fromImage(QImage(QString::fromStdString(inFolder(name).string())));
  }
  /// The names of files with an ending, in order, without it.
  [[nodiscard]] std::vector<std::string> namesOf(const std::string &ending) const {
    std::vector<std::string> names;
    for (const auto &entry : std::filesystem::directory_iterator(folder()))
      if (entry.path().extension() == ending)
        names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
  }
};

void expectAlike(const RgbaImage &one, const RgbaImage &other, const test::Nearby &nearby, std::size_t most) {
  ASSERT_EQ(one.width, other.width);
  ASSERT_EQ(one.height, other.height);
  const test::Patch patch = test::largestDifference(one, other, nearby);
  EXPECT_LE(patch.area, most) << patch.text();
}

void expectFigure(const std::string &content, const std::string &ending, const std::string &session) {
  for (const char *pixels : {"<image", "/Subtype/Image", "/Subtype /Image", "includegraphics"})
    EXPECT_EQ(content.find(pixels), std::string::npos) << pixels;
  const Carrier *carrier = carrierOf(content);
  ASSERT_EQ(carrier == nullptr, ending == ".tex");
  if (carrier) {
    EXPECT_EQ(*carrier->take(content), session);
  }
}

TEST_F(StepFigures, InEveryFormat_AreOfVectors_Reopen_AndLookTheSameToOthers) {
  for (const Lesson &lesson : library().lessons)
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
      const std::string name = lesson.id + "-" + std::to_string(i + 1);
      SCOPED_TRACE(name);
      const FigureSubject subject = subjectOf(lesson, &lesson.steps[i]);
      for (const FigureFormat &format : figureFormats()) {
        make(name, format.ending, subject, choicesFor(format));
        expectFigure(contentOf(inFolder(name + format.ending)), format.ending, subject.session);
      }
    }
  if (!canBeLookedAt())
    GTEST_SKIP() << "rsvg-convert, pdftoppm or qpdf is not installed";
  drawSvgs();
  drawPdfs();
  const auto names = namesOf(".svg");
  const auto pages = namesOf(".ppm");
  ASSERT_EQ(names.size(), pages.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    SCOPED_TRACE(names[i]);
    expectAlike(picture(names[i] + ".svg.png"), picture(pages[i] + ".ppm"), sameVectors, largestOfVectors);
  }
}

/// Without labels: where there is little room they stand elsewhere among pixels than among vectors.
Figure unlabelled(const Figure &figure) {
  Figure bare;
  for (Mark mark : figure.marks) {
    baseOf(mark).label.clear();
    baseOf(mark).numbers.clear();
    bare.add(std::move(mark));
  }
  return bare;
}

/// All of a lesson, to be compared with what pixels show.
FigureSubject unlabelledSubject(const Lesson &lesson) {
  FigureSubject subject = subjectOf(lesson, nullptr);
  subject.content.figure = unlabelled(subject.content.figure);
  return subject;
}

/// Vectors with as much of the hidden lines as pixels show.
FigureChoices likePixels() {
  FigureChoices choices = choicesFor(".svg");
  choices.hidden = HiddenLines::Paler;
  return choices;
}

TEST_F(StepFigures, OfVectors_ShowWhatThoseOfPixelsShow) {
  if (!canBeLookedAt())
    GTEST_SKIP() << "rsvg-convert, pdftoppm or qpdf is not installed";
  for (const Lesson &lesson : library().lessons) {
    const FigureSubject subject = unlabelledSubject(lesson);
    make(lesson.id, ".svg", subject, likePixels());
    make(lesson.id, ".png", subject, choicesFor(".png"));
  }
  drawSvgs();
  for (const Lesson &lesson : library().lessons) {
    SCOPED_TRACE(lesson.id);
    expectAlike(picture(lesson.id + ".svg.png"), picture(lesson.id + ".png"), sameMarks, largestOfMarks);
  }
}

TEST_F(StepFigures, ThatLackAMark_AreToldFromThoseThatHaveIt) {
  if (!canBeLookedAt())
    GTEST_SKIP() << "rsvg-convert, pdftoppm or qpdf is not installed";
  const FigureSubject whole = unlabelledSubject(*library().find("ray-triangle-perp"));
  make("whole", ".svg", whole, likePixels());
  make("whole", ".png", whole, choicesFor(".png"));
  const auto &marks = whole.content.figure.marks;
  for (std::size_t left = 0; left < marks.size(); ++left) {
    FigureSubject lacking = whole;
    lacking.content.figure = {};
    for (std::size_t i = 0; i < marks.size(); ++i)
      if (i != left)
        lacking.content.figure.add(marks[i]);
    make(std::to_string(left), ".svg", lacking, likePixels());
  }
  drawSvgs();
  int missed = 0;
  for (std::size_t left = 0; left < marks.size(); ++left) {
    SCOPED_TRACE(baseOf(marks[left]).id);
    const RgbaImage lacking = picture(std::to_string(left) + ".svg.png");
    if (test::largestDifference(picture("whole.svg.png"), lacking, sameVectors).area < leastMissed)
      continue; // another one is drawn in the same place, or it is a point
    EXPECT_GT(test::largestDifference(picture("whole.png"), lacking, sameMarks).area, largestOfMarks);
    ++missed;
  }
  EXPECT_GE(missed, 5);
}

} // namespace
} // namespace halfspace
