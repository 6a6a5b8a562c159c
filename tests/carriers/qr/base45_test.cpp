#include "widgets/carriers/qr/base45.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

TEST(Base45, OfTheExamplesOfItsDocument_IsAsThere) {
  EXPECT_EQ(base45("AB"), "BB8");
  EXPECT_EQ(base45("Hello!!"), "%69 VD92EX0");
  EXPECT_EQ(base45("base-45"), "UJCLQE7W581");
  EXPECT_EQ(fromBase45("QED8WEX0"), "ietf!");
}

TEST(Base45, OfAllBytes_GivesThemAgain) {
  std::string bytes;
  EXPECT_EQ(fromBase45(base45(bytes)), bytes);
  for (int byte = 0; byte < 256; ++byte) {
    bytes += static_cast<char>(byte);
    EXPECT_EQ(fromBase45(base45(bytes)), bytes);
  }
}

TEST(FromBase45, OfWhatIsNone_IsNothing) {
  // One digit alone, letters that are none of it, three digits beyond two bytes, two beyond one.
  for (const char *text : {"A", "BB8A", "bb8", "B\n8", "GGW", ":::", "V5", "::"})
    EXPECT_FALSE(fromBase45(text)) << text;
}

} // namespace
} // namespace halfspace
