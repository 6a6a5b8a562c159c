// PNG pictures from other hands.
#include "tests/carriers/pictures.h"
#include "widgets/carriers/deflate.h"

#include <zlib.h>

namespace halfspace {
namespace {

using test::sentenceOf;
using namespace std::string_literals;

constexpr std::size_t beginning = 8 + 25; ///< the signature and the picture's sizes
constexpr std::size_t endChunk = 12;

std::string bytesOf(std::size_t number) {
  std::string bytes;
  for (const unsigned shift : {24U, 16U, 8U, 0U})
    bytes += static_cast<char>(number >> shift & 0xFFU);
  return bytes;
}

std::string chunk(const std::string &type, const std::string &data) {
  const std::string checked = type + data;
  return bytesOf(data.size()) + checked +
         bytesOf(crc32_z(0, reinterpret_cast<const Bytef *>(checked.data()), checked.size()));
}

/// The picture with more chunks in front of its pixels.
std::string pngWith(const std::string &chunks) { return test::pngPicture().insert(beginning, chunks); }

Result<std::string> taken(const std::string &png) { return test::carrierCalled("PNG").take(png); }

const std::string ours = "halfspace-session\0"s;

TEST(PngCarrier, BehindForeignTexts_IsFound_AlsoWhereTheirChecksumsAreWrong) {
  const std::string foreign = chunk("iTXt", "Comment\0\0\0\0\0halfspace-session"s) +
                              chunk("tEXt", "Software\0Somebody's"s) + chunk("iTXt", "") +
                              chunk("zTXt", "mxfile\0\0damaged"s) + chunk("prVt", std::string(3000, 'x'));
  std::string png = test::carrierCalled("PNG").put(test::pngPicture(), test::someSession());
  EXPECT_EQ(sentenceOf(taken(png.insert(beginning, foreign))), "taken: " + test::someSession());
  png[beginning + 4 + 4 + 30] ^= 1;
  EXPECT_EQ(sentenceOf(taken(png)), "taken: " + test::someSession());
}

TEST(PngCarrier, BehindThePixels_IsFound) {
  const std::string text = chunk("iTXt", ours + "\1\0en\0Szene\0"s + deflated(test::someSession()));
  std::string png = test::pngPicture();
  EXPECT_EQ(sentenceOf(taken(png.insert(png.size() - endChunk, text))), "taken: " + test::someSession());
}

TEST(PngCarrier, AsTheOlderKindsOfText_IsFound) {
  EXPECT_EQ(sentenceOf(taken(pngWith(chunk("tEXt", ours + test::someSession())))),
            "taken: " + test::someSession());
  EXPECT_EQ(sentenceOf(taken(pngWith(chunk("zTXt", ours + "\0"s + deflated(test::someSession()))))),
            "taken: " + test::someSession());
  EXPECT_EQ(sentenceOf(taken(pngWith(chunk("iTXt", ours + "\0\0\0\0"s + test::someSession())))),
            "taken: " + test::someSession());
}

TEST(PngCarrier, BehindTheEnd_IsNotLookedFor) {
  EXPECT_EQ(sentenceOf(taken(test::pngPicture() + chunk("tEXt", ours + test::someSession()))), test::foreign);
}

TEST(PngCarrier, WhoseTextIsDamaged_SaysSo) {
  const std::string damaged = "The scene in this picture is damaged, and cannot be read any more.";
  std::string wrongChecksum = chunk("tEXt", ours + test::someSession());
  wrongChecksum.back() ^= 1;
  EXPECT_EQ(sentenceOf(taken(pngWith(wrongChecksum))), damaged);
  for (const std::string &data : {""s, "\1"s, "\1\0"s, "\1\0en"s, "\1\7\0\0"s, "\1\0\0\0no zlib"s})
    EXPECT_EQ(sentenceOf(taken(pngWith(chunk("iTXt", ours + data)))), damaged);
  for (const std::string &data : {""s, "\7"s, "\0"s, "\0no zlib"s})
    EXPECT_EQ(sentenceOf(taken(pngWith(chunk("zTXt", ours + data)))), damaged);
}

TEST(PngCarrier, ThatIsCutOffBeforeItsText_SaysThatItIs) {
  const std::string sentence =
      "This picture is damaged or cut off, and no scene of Halfspace is found in it.";
  const std::string png = test::pngPicture();
  EXPECT_EQ(sentenceOf(taken(png.substr(0, png.size() - 1))), sentence);
  EXPECT_EQ(sentenceOf(taken(png.substr(0, 8))), sentence);
  EXPECT_EQ(sentenceOf(taken(png.substr(0, beginning) + "\xFF\xFF\xFF\xFFtEXt")), sentence);
}

} // namespace
} // namespace halfspace
