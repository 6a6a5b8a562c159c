// GIF files, read back by giflib.
#include "tests/animation/encoded.h"

#include <gif_lib.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

namespace halfspace {
namespace {

using test::encode;
using test::filesIn;
using test::movingSquare;
using test::requestFor;

/// What a viewer shows of a file.
struct ReadGif {
  PixelSize size;
  std::vector<int> delays;         ///< in hundredths of a second
  std::vector<RgbaImage> pictures; ///< as they are seen one after the other
  bool goesOnForEver = false;
};

void draw(const SavedImage &image, const GraphicsControlBlock &control, const ColorMapObject &colors,
          RgbaImage &screen) {
  const GifImageDesc &part = image.ImageDesc;
  for (int y = 0; y < part.Height; ++y)
    for (int x = 0; x < part.Width; ++x) {
      const int index = image.RasterBits[y * part.Width + x];
      if (index == control.TransparentColor)
        continue;
      const GifColorType color = colors.Colors[index];
      std::uint8_t *pixel =
          screen.rgba.data() + 4 * (std::ptrdiff_t{part.Top + y} * screen.width + part.Left + x);
      pixel[0] = color.Red;
      pixel[1] = color.Green;
      pixel[2] = color.Blue;
      pixel[3] = 255;
    }
}

ReadGif read(const std::filesystem::path &file) {
  ReadGif gif;
  GifFileType *opened = DGifOpenFileName(file.c_str(), nullptr);
  if (!opened || DGifSlurp(opened) != GIF_OK) {
    ADD_FAILURE() << "giflib cannot read " << file;
    return gif;
  }
  gif.size = {opened->SWidth, opened->SHeight};
  const auto bytes = static_cast<std::size_t>(4 * gif.size.width * gif.size.height);
  const RgbaImage clear{gif.size.width, gif.size.height, std::vector<std::uint8_t>(bytes)};
  RgbaImage screen = clear;
  for (int i = 0; i < opened->ImageCount; ++i) {
    GraphicsControlBlock control{};
    EXPECT_EQ(DGifSavedExtensionToGCB(opened, i, &control), GIF_OK);
    gif.delays.push_back(control.DelayTime);
    draw(opened->SavedImages[i], control, *opened->SColorMap, screen);
    gif.pictures.push_back(screen);
    if (control.DisposalMode == DISPOSE_BACKGROUND)
      screen = clear;
    for (int j = 0; j < opened->SavedImages[i].ExtensionBlockCount; ++j) {
      const ExtensionBlock &block = opened->SavedImages[i].ExtensionBlocks[j];
      if (block.Function == APPLICATION_EXT_FUNC_CODE)
        gif.goesOnForEver = std::string(block.Bytes, block.Bytes + block.ByteCount) == "NETSCAPE2.0";
    }
  }
  DGifCloseFile(opened, nullptr);
  return gif;
}

class Gif : public ProgramTest {};

TEST_F(Gif, HasItsPicturesDelaysAndSize_AndGoesOnForEver) {
  EXPECT_FALSE(encode(requestFor(inFolder("a.gif"), {40, 20}), 12));
  const ReadGif gif = read(inFolder("a.gif"));
  EXPECT_EQ(gif.size, (PixelSize{40, 20}));
  EXPECT_EQ(gif.delays, std::vector<int>(12, 4));
  EXPECT_TRUE(gif.goesOnForEver);
  ASSERT_EQ(gif.pictures.size(), 12U);
  for (int i = 0; i < 12; ++i) // few colours are exact
    EXPECT_EQ(gif.pictures[static_cast<std::size_t>(i)].rgba, movingSquare({40, 20}, i).rgba) << i;
  EXPECT_EQ(filesIn(folder()), 1);
}

TEST_F(Gif, WithoutABackground_ShowsNothingOfThePictureBefore) {
  EncodingRequest request = requestFor(inFolder("a.gif"), {40, 20});
  request.isTransparent = true;
  EXPECT_FALSE(encode(request, 5));
  const ReadGif gif = read(inFolder("a.gif"));
  ASSERT_EQ(gif.pictures.size(), 5U);
  const RgbaImage expected = movingSquare({40, 20}, 4, true);
  for (std::size_t i = 3; i < expected.rgba.size(); i += 4)
    ASSERT_EQ(gif.pictures[4].rgba[i], expected.rgba[i]);
}

TEST_F(Gif, OfAPictureThatStays_TakesNoMoreThanSomeBytesForIt) {
  EncodingRequest request = requestFor(inFolder("a.gif"), {400, 200});
  const auto encoder = animationFormatOf("a.gif")->begin(request);
  ASSERT_TRUE(encoder);
  (*encoder)->preview(movingSquare(request.size, 0));
  for (int i = 0; i < 50; ++i)
    EXPECT_FALSE((*encoder)->add(movingSquare(request.size, 0)));
  EXPECT_FALSE((*encoder)->finish());
  EXPECT_EQ(read(inFolder("a.gif")).pictures.size(), 50U);
  EXPECT_LT(std::filesystem::file_size(inFolder("a.gif")), 4000U);
}

TEST_F(Gif, OfATimeThatItCannotTell_IsRefused) {
  for (const int framesPerSecond : {3, 30, 60}) {
    EncodingRequest request = requestFor(inFolder("a.gif"), {40, 20});
    request.framesPerSecond = framesPerSecond;
    EXPECT_TRUE(encode(request, 1)) << framesPerSecond;
  }
  for (const int framesPerSecond : {1, 10, 20, 25, 50}) {
    EncodingRequest request = requestFor(inFolder("a.gif"), {40, 20});
    request.framesPerSecond = framesPerSecond;
    EXPECT_FALSE(encode(request, 1)) << framesPerSecond;
    EXPECT_EQ(read(inFolder("a.gif")).delays.front(), 100 / framesPerSecond);
  }
}

TEST_F(Gif, ThatIsGivenUp_LeavesTheOldFile) {
  write("a.gif", "old");
  {
    const auto encoder = animationFormatOf("a.gif")->begin(requestFor(inFolder("a.gif"), {40, 20}));
    ASSERT_TRUE(encoder);
    EXPECT_FALSE((*encoder)->add(movingSquare({40, 20}, 0)));
  }
  EXPECT_EQ(contentOf(inFolder("a.gif")), "old");
  EXPECT_EQ(filesIn(folder()), 1);
}

TEST_F(Gif, WithoutRoomOnTheDisk_IsToldSo_AndLeavesNothing) {
  // In a process of its own, as the limit cannot be lifted again.
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{2000, 2000};
    const auto problem = setrlimit(RLIMIT_FSIZE, &limit) == 0
                             ? encode(requestFor(inFolder("a.gif"), {400, 200}), 50)
                             : std::nullopt;
    _exit(problem && problem->sentence == "This cannot be written: the file would be larger than it may be."
              ? 0
              : 1);
  }
  int ended = -1;
  ASSERT_EQ(waitpid(child, &ended, 0), child);
  EXPECT_EQ(ended, 0);
  EXPECT_EQ(filesIn(folder()), 0);
}

TEST_F(Gif, InNoFolder_IsRefusedAtTheBeginning) {
  EXPECT_FALSE(animationFormatOf("a.gif")->begin(requestFor(inFolder("no/a.gif"), {40, 20})));
}

} // namespace
} // namespace halfspace
