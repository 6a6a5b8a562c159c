#include "widgets/carriers/base64.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

TEST(Base64, OfTheTextsOfItsRfc_IsAsThere) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, ReadAgain_IsEveryByte_WithWhiteSpaceAnywhere) {
  std::string bytes;
  for (int byte = 0; byte < 256; ++byte) {
    bytes += static_cast<char>(byte);
    std::string text = base64(bytes);
    for (std::size_t place = 0; place < text.size(); place += 7)
      text.insert(place, " \r\n\t");
    EXPECT_EQ(fromBase64(text), bytes);
  }
}

TEST(Base64, OfAnythingElse_IsNone) {
  EXPECT_FALSE(fromBase64("Zm9v!"));
  EXPECT_FALSE(fromBase64("Zg==Zg=="));
  EXPECT_FALSE(fromBase64("\xC3\xA4"));
}

} // namespace
} // namespace halfspace
