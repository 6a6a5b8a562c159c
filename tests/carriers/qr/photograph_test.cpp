// Sessions out of photographs of their codes, and what is said of other photographs.
#include "widgets/carriers/qr/photograph.h"

#include "tests/carriers/pictures.h"
#include "tests/carriers/qr/photographing.h"
#include "tests/effort.h"

#include <gtest/gtest.h>
#include <memory>
#include <qrencode.h>

namespace halfspace {
namespace {

using test::drawn;
using test::Shot;

constexpr const char *nothing = "nothing";

std::string foundIn(const std::string &picture, unsigned seconds = mostSearchSeconds) {
  const auto found = sessionInPhotograph(picture, seconds);
  return found ? test::sentenceOf(*found) : nothing;
}

/// As long as a lesson's session is once it is packed.
std::string longSession(std::uint32_t seed) {
  std::mt19937 dice(seed);
  std::string session = test::someSession();
  while (session.size() < 350)
    session += static_cast<char>(dice());
  return session;
}

/// Somebody else's code.
QrCode foreignCode() {
  const std::unique_ptr<QRcode, decltype(&QRcode_free)> symbol(
      QRcode_encodeString("https://www.example.org", 0, QR_ECLEVEL_M, QR_MODE_8, 1), &QRcode_free);
  QrCode code{symbol->width, {}};
  for (int i = 0; i < symbol->width * symbol->width; ++i)
    code.modules.push_back((symbol->data[i] & 1U) != 0);
  return code;
}

/// One image above the other, both of the same width.
GreyImage above(GreyImage upper, const GreyImage &lower) {
  upper.height += lower.height;
  upper.pixels.insert(upper.pixels.end(), lower.pixels.begin(), lower.pixels.end());
  return upper;
}

TEST(Photograph, OfACodeOnAPageOfA4_GivesItsSession) {
  constexpr double ofTwelveMegapixels = 13;
  const std::vector<Shot> shots{
      {0, ofTwelveMegapixels, 0, 0, 0, 0},     {-8, ofTwelveMegapixels, 0, 1, 0, 0},
      {33, ofTwelveMegapixels, 0, 1, 8, 0},    {95, ofTwelveMegapixels, 0.05, 1, 8, 0.3},
      {5, ofTwelveMegapixels, 0.1, 1, 8, 0.4}, {20, ofTwelveMegapixels, 0.15, 0.8, 12, 0.6},
      {3, ofTwelveMegapixels, 0, 2, 5, 0},     {180, ofTwelveMegapixels, 0, 0.5, 20, 0}};
  for (std::uint32_t i = 0; i < shots.size(); ++i) {
    SCOPED_TRACE(i);
    const std::string session = longSession(i);
    const QrCode code = *qrCodeOf(session);
    const GreyImage image = test::Camera(code, shots[i]).photograph(i);
    EXPECT_EQ(foundIn(test::jpegOf(image)), "taken: " + session);
    EXPECT_EQ(foundIn(test::pngOf(image)), "taken: " + session);
  }
}

TEST(Photograph, InWhichModulesAreTwoOrThreePixelsWide_GivesItsSession) {
  const std::string session = longSession(0);
  const QrCode code = *qrCodeOf(session);
  for (const double pixelsPerMillimetre : {6.0, 8.0})
    for (const double degrees : {0.0, 7.0, 33.0}) {
      SCOPED_TRACE(std::to_string(pixelsPerMillimetre) + " at " + std::to_string(degrees));
      const GreyImage image =
          test::Camera(code, {degrees, pixelsPerMillimetre, 0.05, 0.5, 5, 0.3}).photograph(1);
      EXPECT_EQ(foundIn(test::jpegOf(image)), "taken: " + session);
    }
}

TEST(Photograph, InAnyJpeg_GivesItsSession_AlsoWhereItsEndIsCutOff) {
  const std::string session = longSession(0);
  const GreyImage image = drawn(*qrCodeOf(session));
  EXPECT_EQ(foundIn(test::jpegOf(image, 60, TJFLAG_PROGRESSIVE)), "taken: " + session);
  const std::string whole = test::jpegOf(image);
  EXPECT_EQ(foundIn(whole.substr(0, whole.size() - 20)), "taken: " + session);
}

TEST(Photograph, WithoutACode_HasNothing) {
  EXPECT_EQ(foundIn(test::pngPicture()), nothing);
  EXPECT_EQ(foundIn(test::jpegOf({40, 30, std::vector<std::uint8_t>(1200, 200)})), nothing);
}

TEST(Photograph, OfSomebodyElsesCode_SaysSo_AndPassesOverItBesideOurs) {
  const GreyImage foreign = drawn(foreignCode(), 400);
  EXPECT_EQ(foundIn(test::pngOf(foreign)), "The QR code in this picture holds no scene of Halfspace.");
  const GreyImage ours = drawn(*qrCodeOf(test::someSession()), 400);
  EXPECT_EQ(foundIn(test::pngOf(above(ours, foreign))), "taken: " + test::someSession());
}

TEST(Photograph, OfSeveralCodes_SaysHowMany_UnlessTheySayTheSame) {
  const GreyImage one = drawn(*qrCodeOf(longSession(1)), 500);
  const GreyImage other = drawn(*qrCodeOf(longSession(2)), 500);
  EXPECT_EQ(foundIn(test::pngOf(above(one, other))),
            "2 QR codes in this picture hold scenes. Photograph one of them alone, or cut it out.");
  EXPECT_EQ(foundIn(test::pngOf(above(one, one))), "taken: " + longSession(1));
}

/// ZXing tells of such codes from 2.0 on.
TEST(Photograph, OfACodeThatIsCovered_HasNothing_OrSaysSo) {
  QrCode code = *qrCodeOf(longSession(1));
  // More than any error correction makes up for, and none of what tells where the code is.
  for (int row = code.side / 4; row < code.side - 10; ++row)
    for (int column = code.side / 4; column < code.side - 10; ++column)
      code.modules[std::size_t(row) * std::size_t(code.side) + std::size_t(column)].flip();
  const std::string sentence = foundIn(test::pngOf(drawn(code)));
  EXPECT_TRUE(sentence == nothing || sentence.find("blurred or covered") != std::string::npos) << sentence;
}

TEST(Photograph, ThatIsDamaged_SaysSo) {
  const std::string sentence =
      "This picture is damaged or cut off, and no scene of Halfspace is found in it.";
  const std::string png = test::pngPicture();
  EXPECT_EQ(foundIn(png.substr(0, 60)), sentence);
  EXPECT_EQ(foundIn("\xFF\xD8\xFF"), sentence);
  EXPECT_EQ(foundIn("\xFF\xD8\xFF\xE0 no picture"), sentence);
}

TEST(Photograph, OfTooManyPixels_IsNotUnpacked) {
  std::string png = test::pngPicture();
  // The sizes of the picture, with the checksum of that chunk.
  png.replace(16, 17, std::string("\0\0\x7f\xff\0\0\x7f\xff\x08\x02\0\0\0\xc6\x90\x91\x6a", 17));
  const std::string sentence = foundIn(png);
  EXPECT_NE(sentence.find("at most 64 million"), std::string::npos) << sentence;
}

TEST(Photograph, ThatGoesOverItsPixelsTooOften_IsNotUnpacked) {
  std::string jpeg = test::jpegOf(drawn(*qrCodeOf("x")));
  const auto scan = jpeg.find("\xFF\xDA");
  const std::string again = jpeg.substr(scan, jpeg.size() - 2 - scan);
  for (int i = 0; i < 30; ++i)
    jpeg.insert(scan, again);
  const std::string sentence = foundIn(jpeg);
  EXPECT_NE(sentence.find("too often"), std::string::npos) << sentence;
}

TEST(Photograph, OfHundredsOfCornersOfCodes_IsGivenUpInTime) {
  constexpr int cell = 36;
  GreyImage image{1200, 1200, {}};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const int column = x % cell / 4;
      const int row = y % cell / 4;
      const int ring = std::max(std::abs(column - 3), std::abs(row - 3));
      image.pixels.push_back(ring == 2 || ring > 3 ? 255 : 0);
    }
  const std::string sentence = foundIn(test::pngOf(image), 1);
  EXPECT_NE(sentence.find("takes too much time"), std::string::npos) << sentence;
}

} // namespace
} // namespace halfspace
