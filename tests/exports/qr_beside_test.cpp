// Codes beside figures of vectors and of pixels.
#include "widgets/exports/qr_beside.h"

#include "widgets/carriers/qr/qr_text.h"
#include "widgets/carriers/qr/read_codes.h"
#include "widgets/exports/paper_look.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

constexpr double millimetre = pointsPerCentimetre / 10;
constexpr double module = moduleMillimetres * millimetre;
constexpr Color night{20, 24, 32};

const std::string session = "{\n \"format\": \"halfspace\",\n \"lesson\": \"a\"\n}\n";

const QrCode &code() {
  static const QrCode made = *qrCodeOf(session);
  return made;
}
double side() { return millimetresOf(code()) * millimetre; }

Drawing figure(glm::dvec2 size) {
  Drawing drawing{size, night};
  PathPart line;
  line.path = straightPath({{1, 1}, {9, 9}}, false);
  line.pen = Pen{};
  drawing.parts = {line};
  drawing.description = "A line.";
  return drawing;
}

struct Rectangle {
  glm::dvec2 low{};
  glm::dvec2 high{};
};

/// Those that a path is made of.
std::vector<Rectangle> rectanglesOf(const DrawingPart &part) {
  const PagePath &path = std::get<PathPart>(part).path;
  constexpr std::size_t steps = 5; // four corners, and back
  EXPECT_EQ(path.steps.size() % steps, 0U);
  std::vector<Rectangle> rectangles;
  for (std::size_t i = 0; i < path.steps.size(); i += steps) {
    EXPECT_EQ(path.steps[i].kind, PageStep::Kind::Move);
    EXPECT_EQ(path.steps[i + steps - 1].kind, PageStep::Kind::Close);
    rectangles.push_back({path.steps[i].to, path.steps[i + 2].to});
  }
  return rectangles;
}

TEST(QrBeside, AFigureOfVectors_MakesThePageWiderByItsSide) {
  const Drawing with = withQrCode(figure({200, 300}), code());
  EXPECT_DOUBLE_EQ(with.size.x, 200 + side());
  EXPECT_DOUBLE_EQ(with.size.y, 300);
  EXPECT_EQ(with.ground, night);
  EXPECT_EQ(with.description, "A line. The QR code beside the figure holds its scene for Halfspace.");
  const auto zone = rectanglesOf(with.parts.at(1));
  ASSERT_EQ(zone.size(), 1U);
  EXPECT_DOUBLE_EQ(zone[0].low.x, 200);
  EXPECT_DOUBLE_EQ(zone[0].low.y, 300 - side());
  EXPECT_DOUBLE_EQ(zone[0].high.x, with.size.x);
  EXPECT_DOUBLE_EQ(zone[0].high.y, 300);
}

TEST(QrBeside, AFigureThatIsLowerThanIt_LeavesNothingOffThePage) {
  const Drawing right = withQrCode(figure({200, 30}), code());
  EXPECT_DOUBLE_EQ(right.size.y, side());
  EXPECT_DOUBLE_EQ(rectanglesOf(right.parts.at(1))[0].low.y, 0);
}

TEST(QrBeside, AFigureOfVectors_IsBlackOnWhite_EachDarkModuleInOneRectangle) {
  const Drawing with = withQrCode(figure({200, 300}), code());
  ASSERT_EQ(with.parts.size(), 3U);
  EXPECT_EQ(std::get<PathPart>(with.parts[1]).fill, (Fill{{255, 255, 255}}));
  EXPECT_EQ(std::get<PathPart>(with.parts[2]).fill, (Fill{{0, 0, 0}}));
  const glm::dvec2 start = rectanglesOf(with.parts[1])[0].low + quietModules * module;
  const auto dark = rectanglesOf(with.parts[2]);
  EXPECT_LT(dark.size(), code().modules.size() / 3);
  double area = 0;
  for (const Rectangle &each : dark)
    area += (each.high.x - each.low.x) * (each.high.y - each.low.y);
  int count = 0;
  for (int row = 0; row < code().side; ++row)
    for (int column = 0; column < code().side; ++column) {
      const glm::dvec2 middle = start + module * glm::dvec2(column + 0.5, row + 0.5);
      const auto covers = [&](const Rectangle &each) {
        return each.low.x < middle.x && middle.x < each.high.x && each.low.y < middle.y &&
               middle.y < each.high.y;
      };
      EXPECT_EQ(std::count_if(dark.begin(), dark.end(), covers), code().isDark(column, row) ? 1 : 0);
      count += code().isDark(column, row) ? 1 : 0;
    }
  EXPECT_NEAR(area, count * module * module, 1e-6);
}

RgbaImage grey(int width, int height) {
  RgbaImage image{width, height, {}};
  for (int i = 0; i < width * height; ++i)
    image.rgba.insert(image.rgba.end(), {90, 100, static_cast<std::uint8_t>(i % 7), 200});
  return image;
}

std::array<int, 4> pixelAt(const RgbaImage &image, int x, int y) {
  const std::uint8_t *pixel =
      image.rgba.data() + 4 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x));
  return {pixel[0], pixel[1], pixel[2], pixel[3]};
}

/// What a reader of codes finds in it, as it lies on white.
std::vector<ReadCode> read(const RgbaImage &image) {
  GreyImage seen{image.width, image.height, {}};
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    seen.pixels.push_back(image.rgba[i + 3] == 0 ? 255 : image.rgba[i]);
  return readCodes(seen);
}

TEST(QrBeside, AFigureOfPixels_HasModulesOfWholePixels_AndLeavesTheFigureAsItIs) {
  constexpr double dpi = 300; // a module is 4.7 pixels wide
  constexpr int pixels = 5;
  const int zone = pixels * (code().side + 2 * quietModules);
  const RgbaImage image = grey(40, 700);
  for (const std::optional<Color> ground : {std::optional<Color>(), std::optional(night)}) {
    const RgbaImage with = withQrCode(image, code(), dpi, ground);
    ASSERT_EQ(with.width, 40 + zone);
    ASSERT_EQ(with.height, 700);
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        ASSERT_EQ(pixelAt(with, x, y), pixelAt(image, x, y));
    EXPECT_EQ(pixelAt(with, 41, 0), (ground ? std::array{20, 24, 32, 255} : std::array{0, 0, 0, 0}));
    for (int y = 0; y < zone; ++y)
      for (int x = 0; x < zone; ++x) {
        const int column = x / pixels - quietModules;
        const int row = y / pixels - quietModules;
        const bool isDark = column >= 0 && row >= 0 && column < code().side && row < code().side &&
                            code().isDark(column, row);
        const int shade = isDark ? 0 : 255;
        ASSERT_EQ(pixelAt(with, 40 + x, 700 - zone + y), (std::array{shade, shade, shade, 255}));
      }
  }
}

TEST(QrBeside, AFigureOfPixels_IsReadAtEveryResolution) {
  for (const double dpi : {96.0, 150.0, 300.0, 600.0}) {
    const auto codes = read(withQrCode(grey(300, 200), code(), dpi, night));
    ASSERT_EQ(codes.size(), 1U) << dpi;
    EXPECT_EQ(*sessionInQrText(codes[0].text), session);
  }
}

} // namespace
} // namespace halfspace
