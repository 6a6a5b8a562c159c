// Figures of vectors from the command line.
#include "tests/app/command_fixture.h"

#include <cmath>

namespace halfspace {
namespace {

class VectorFigures : public Program {
protected:
  [[nodiscard]] std::string file(const std::string &name) const { return contentOf(inFolder(name)); }
  [[nodiscard]] bool has(const std::string &program) const {
    return shell("command -v " + program + " >.out 2>.err").status == 0;
  }
};

TEST_F(VectorFigures, AreAsWideAsAsked_AndTheSameBytesAgain) {
  for (const std::string ending : {"svg", "pdf", "tex"}) {
    const std::string command = "render signed-distance --step 2 --width 8cm --text 9pt --size 1600x1000 -o ";
    EXPECT_EQ(run(command + "a." + ending).status, 0);
    EXPECT_EQ(run(command + "b." + ending).status, 0);
    EXPECT_FALSE(file("a." + ending).empty());
    EXPECT_EQ(file("a." + ending), file("b." + ending)) << ending;
  }
  EXPECT_NE(file("a.svg").find("width=\"226.77pt\" height=\"141.73pt\""), std::string::npos);
  EXPECT_NE(file("a.pdf").find("/MediaBox[0 0 226.77 141.73]"), std::string::npos);
  EXPECT_NE(file("a.tex").find("(0,0)rectangle(226.77,141.73)"), std::string::npos);
}

TEST_F(VectorFigures, AreDescribedByTheCaseOfTheirScene) {
  EXPECT_EQ(run("render signed-distance -o a.svg --set Q=1,1,1").status, 0);
  const std::string told = explained("signed-distance --set Q=1,1,1").at("outcomes").dump();
  const std::string svg = file("a.svg");
  const auto begin = svg.find("<desc>") + 6;
  const std::string description = svg.substr(begin, svg.find("</desc>") - begin);
  EXPECT_GT(description.size(), 20U);
  EXPECT_NE(told.find(description.substr(0, description.find('.'))), std::string::npos) << description;
}

TEST_F(VectorFigures, DrawHiddenLinesAsAsked) {
  for (const std::string hidden : {"dashed", "paler", "left-out"})
    EXPECT_EQ(run("render ray-prism-pluecker -o " + hidden + ".svg --hidden " + hidden).status, 0);
  EXPECT_NE(file("dashed.svg").find("class=\"hidden\""), std::string::npos);
  EXPECT_EQ(file("left-out.svg").find("class=\"hidden\""), std::string::npos);
  EXPECT_NE(file("dashed.svg"), file("paler.svg"));
}

TEST_F(VectorFigures, OfAFlight_AreOneForEachFrame) {
  EXPECT_EQ(run("render photon-torpedo --set seed=7 --frames 38:40 -o %02d.pdf").status, 0);
  EXPECT_EQ(run("render photon-torpedo --set seed=7 --frame 40 -o alone.pdf").status, 0);
  EXPECT_EQ(file("40.pdf"), file("alone.pdf"));
  EXPECT_NE(file("38.pdf"), file("40.pdf"));
}

TEST_F(VectorFigures, MayBeFlat) {
  EXPECT_EQ(run("render ray-plane-picture --flat --width 6cm --size 1200x1000 -o flat.svg").status, 0);
  EXPECT_NE(file("flat.svg").find("width=\"170.08pt\" height=\"141.73pt\""), std::string::npos);
  EXPECT_NE(file("flat.svg").find("<path"), std::string::npos);
  EXPECT_NE(file("flat.svg").find("aria-label=\"Q"), std::string::npos);
}

TEST_F(VectorFigures, ThatCannotBeMade_AreRefusedInASentence) {
  expectRefused("render signed-distance -o a.svg --width wide", "--width takes a length");
  expectRefused("render signed-distance -o a.svg --width 1e9cm", "from 1cm to 100cm");
  expectRefused("render signed-distance -o a.svg --text 9", "--text takes a size");
  expectRefused("render signed-distance -o a.svg --text 0pt", "--text takes a size");
  expectRefused("render signed-distance -o a.svg --width 2cm --text 9pt", "too large for a figure 2cm wide");
  expectRefused("render signed-distance -o a.svg --hidden no", "dashed, paler or left-out");
  expectRefused("render signed-distance -o a.png --width 8cm", "--width is for figures of vectors");
  expectRefused("render signed-distance --flat -o a.svg", "no flat picture");
  expectRefused("render signed-distance -o no-such-folder/a.svg", "no-such-folder/a.svg");
}

/// A picture in so few pixels that it only tells what stands where.
QImage coarse(const QImage &picture) {
  return picture.convertToFormat(QImage::Format_RGB32)
      .scaled(64, 40, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
      .convertToFormat(QImage::Format_Grayscale8);
}

/// How alike two pictures are: 1 where one is as dark as the other wherever it is darker than its middle.
double likeness(const QImage &one, const QImage &other) {
  double ones = 0;
  double others = 0;
  double both = 0;
  const auto darkness = [](const QImage &picture, int x, int y) {
    return 255.0 - qGray(picture.pixel(x, y));
  };
  for (int y = 0; y < one.height(); ++y)
    for (int x = 0; x < one.width(); ++x) {
      ones += std::pow(darkness(one, x, y), 2);
      others += std::pow(darkness(other, x, y), 2);
      both += darkness(one, x, y) * darkness(other, x, y);
    }
  return both / std::sqrt(ones * others);
}

TEST_F(VectorFigures, LookLikeThePictureOfPixels) {
  if (!has("rsvg-convert") || !has("pdftoppm"))
    GTEST_SKIP() << "rsvg-convert or pdftoppm is not installed";
  for (const std::string lesson : {"signed-distance", "plane-plane", "ray-sphere", "ray-triangle-perp",
                                   "photon-torpedo", "determinant"}) {
    SCOPED_TRACE(lesson);
    const std::string render = "render " + lesson + " --theme print ";
    EXPECT_EQ(run(render + "-o pixels.png --size 1600x1000").status, 0);
    // 22 design pixels of type among 1280: the same camera, and labels in the same places.
    const std::string paper = "--width 320pt --text 5.5pt -o vectors.";
    EXPECT_EQ(run(render + paper + "svg").status, 0);
    EXPECT_EQ(run(render + paper + "pdf").status, 0);
    EXPECT_EQ(shell("rsvg-convert -w 1600 -b white vectors.svg -o svg.png >.out 2>.err").status, 0);
    EXPECT_EQ(shell("pdftoppm -singlefile -scale-to-x 1600 -scale-to-y -1 -png vectors.pdf pdf >.out 2>.err")
                  .status,
              0);
    const QImage pixels = coarse(picture("pixels.png"));
    EXPECT_GT(likeness(coarse(picture("svg.png")), pixels), 0.9);
    EXPECT_GT(likeness(coarse(picture("pdf.png")), coarse(picture("svg.png"))), 0.99);
  }
}

} // namespace
} // namespace halfspace
