// Figures of vectors from the command line.
#include "tests/app/command_fixture.h"

#include <cmath>

namespace halfspace {
namespace {

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

class VectorFigures : public Program {
protected:
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
  expectRefused("render signed-distance -o a.png --hidden paler", "--hidden is for figures of vectors");
  expectRefused("render signed-distance -o a.pdf --dpi 300", "--dpi is for PNG pictures");
  expectRefused("render signed-distance -o a.png --dpi 5", "from 10 to 2400");
  expectRefused("render signed-distance -o a.png --width 100cm --dpi 2400", "each side must be 1 to 16384");
  expectRefused("render signed-distance -o a.pdf --svg-text letters", "--svg-text is for SVG");
  expectRefused("render signed-distance -o a.svg --svg-text runes", "--svg-text takes shapes or letters");
  expectRefused("render signed-distance --flat -o a.svg", "no flat picture");
  expectRefused("render signed-distance -o no-such-folder/a.svg", "no-such-folder/a.svg");
}

TEST_F(VectorFigures, OfPixels_AreMeasuredOnPaper_AndSayHowLargeTheyAre) {
  EXPECT_EQ(run("render signed-distance -o a.png --width 8cm --dpi 300 --text 9pt").status, 0);
  EXPECT_EQ(picture("a.png").size(), QSize(945, 591)) << "8 cm of 300 pixels an inch";
  EXPECT_EQ(picture("a.png").dotsPerMeterX(), 11811);
  EXPECT_EQ(run("render signed-distance -o b.png --width 8cm --dpi 600").status, 0);
  EXPECT_EQ(picture("b.png").size(), QSize(1890, 1181)) << "twice as fine, and 9 pt is the usual size";
  const double finer = likeness(coarse(picture("b.png")), coarse(picture("a.png")));
  EXPECT_GT(finer, 0.98);
  EXPECT_EQ(run("render signed-distance -o c.png --width 8cm --text 14pt").status, 0);
  EXPECT_LT(likeness(coarse(picture("c.png")), coarse(picture("a.png"))), finer) << "larger type";
  EXPECT_EQ(run("render signed-distance -o d.png --size 800x500").status, 0);
  EXPECT_EQ(file("d.png").find("pHYs"), std::string::npos) << "nobody said how large its pixels are";
}

/// How many rows at a picture's top have one colour.
int emptyRows(const QImage &picture) {
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      if (picture.pixel(x, y) != picture.pixel(0, 0))
        return y;
  return picture.height();
}

TEST_F(VectorFigures, ThatAreCropped_AreAsWideAsAsked_AndFillTheirPage) {
  // Flat, so that nothing but the figure is on the page.
  const std::string crop = "render ray-plane-picture --flat --theme print --width 8cm --crop -o ";
  for (const std::string ending : {"svg", "png"})
    EXPECT_EQ(run(crop + "a." + ending).status, 0);
  const QImage cropped = picture("a.png");
  EXPECT_EQ(cropped.width(), 945);
  EXPECT_LT(cropped.height(), 591) << "what is above and below is left out";
  constexpr int mostMargin = 40; // a twelfth of an inch, and what a letter does not fill of its line
  for (const QImage &side : {cropped, cropped.mirrored()}) {
    EXPECT_GT(emptyRows(side), 0);
    EXPECT_LT(emptyRows(side), mostMargin);
  }
  EXPECT_NE(file("a.svg").find("width=\"226.77pt\""), std::string::npos);
  EXPECT_EQ(run("render ray-triangle-perp --width 8cm --crop -o b.pdf").status, 0);
  EXPECT_NE(file("b.pdf").find("/MediaBox[0 0 226.77 "), std::string::npos);
}

TEST_F(VectorFigures, OfAFlight_AreCroppedAlike) {
  EXPECT_EQ(run("render photon-torpedo --crop --set seed=7 --frames 38:40 -o %02d.svg").status, 0);
  const auto sizeOf = [](const std::string &svg) { return svg.substr(svg.find("width="), 40); };
  EXPECT_EQ(sizeOf(file("38.svg")), sizeOf(file("40.svg")));
}

TEST_F(VectorFigures, MayHaveLettersForText) {
  EXPECT_EQ(run("render signed-distance -o a.svg --svg-text letters").status, 0);
  EXPECT_NE(file("a.svg").find("<text"), std::string::npos);
  EXPECT_EQ(run("render signed-distance -o b.svg").status, 0);
  EXPECT_EQ(file("b.svg").find("<text"), std::string::npos);
}

} // namespace
} // namespace halfspace
