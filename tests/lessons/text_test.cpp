#include "lessons/text.h"

#include <gtest/gtest.h>

#include <vector>

namespace halfspace {
namespace {

const std::string mark = "\xEF\xBF\xBD"; // what stands for a character that is not shown

TEST(CharacterLength, OfEachForm_IsItsBytes) {
  EXPECT_EQ(characterLength("a"), 1U);
  EXPECT_EQ(characterLength(std::string_view("\0", 1)), 1U);
  EXPECT_EQ(characterLength("ü!"), 2U);
  EXPECT_EQ(characterLength("⊥!"), 3U);
  EXPECT_EQ(characterLength("😀!"), 4U);
  EXPECT_EQ(characterLength("\xC2\x80"), 2U);         // the first of two bytes
  EXPECT_EQ(characterLength("\xE0\xA0\x80"), 3U);     // of three
  EXPECT_EQ(characterLength("\xED\x9F\xBF"), 3U);     // the last before the surrogates
  EXPECT_EQ(characterLength("\xEE\x80\x80"), 3U);     // the first behind them
  EXPECT_EQ(characterLength("\xF0\x90\x80\x80"), 4U); // the first of four
  EXPECT_EQ(characterLength("\xF4\x8F\xBF\xBF"), 4U); // the last of all
}

TEST(CharacterLength, OfWhatIsNotUtf8_IsZero) {
  for (const char *bytes : {"", "\x80", "\xBF", "\xC0\x80", "\xC1\xBF", "\xC3", "\xC3(", "\xE2\x82",
                            "\xE2(\xA1", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xED\xBF\xBF", "\xF0\x8F\xBF\xBF",
                            "\xF0\x9F\x98", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFE", "\xFF"})
    EXPECT_EQ(characterLength(bytes), 0U) << bytes;
}

TEST(FirstNoText, InAText_IsNothing) {
  EXPECT_EQ(firstNoText(""), std::nullopt);
  EXPECT_EQ(firstNoText("# ü⊥😀\tx\r\ny\n"), std::nullopt);
  EXPECT_EQ(firstNoText("\xEF\xBB\xBF with a byte order mark"), std::nullopt);
}

TEST(FirstNoText, AtAnyOtherByte_IsItsPlace) {
  using namespace std::string_literals;
  for (const std::string &bytes : {"\0"s, "\x1B[31m"s, "\x07"s, "\x7F"s, "\xC2\x9B"s, "\xFF"s, "\xC3"s})
    EXPECT_EQ(firstNoText("ü\n" + bytes), 3U) << bytes;
}

TEST(Printable, AText_IsUnchanged) {
  const std::string text = "“n⊥” = (−1, ½)\t\n😀 שלום ";
  EXPECT_EQ(printable(text), text);
  EXPECT_EQ(printable(""), "");
}

TEST(Printable, WhatSteersATerminal_IsReplaced) {
  using namespace std::string_literals;
  EXPECT_EQ(printable("a\x1B[31mb"), "a" + mark + "[31mb");
  EXPECT_EQ(printable("a\rb\bc\x07"), "a" + mark + "b" + mark + "c" + mark);
  EXPECT_EQ(printable("a\0b"s), "a" + mark + "b");
  EXPECT_EQ(printable("\x7F"), mark);
  EXPECT_EQ(printable("\xC2\x9B"
                      "31m\xC2\x80\xC2\x9F"),
            mark + "31m" + mark + mark);
}

TEST(Printable, WhatTurnsTheDirectionOfWriting_IsReplaced) {
  for (const char *turn : {"\u202A", "\u202B", "\u202C", "\u202D", "\u202E", "\u2066", "\u2067", "\u2068",
                           "\u2069", "\u200E", "\u200F", "\u061C"})
    EXPECT_EQ(printable("a" + std::string(turn) + "b"), "a" + mark + "b");
  for (const char *other : {"\u2029", "\u202F", "\u2065", "\u206A", "\u200D", "\u2010"})
    EXPECT_EQ(printable(other), other);
}

TEST(Printable, EachByteThatIsNotUtf8_IsReplaced) {
  EXPECT_EQ(printable("a\xFF\xFE"
                      "b"),
            "a" + mark + mark + "b");
  EXPECT_EQ(printable("\xE2\x8A"), mark + mark);
  EXPECT_EQ(printable("\xED\xA0\x80"), mark + mark + mark);
}

TEST(Printable, WhateverItIsGiven_GivesText) {
  for (int first = 0; first < 256; ++first)
    for (int second = 0; second < 256; ++second) {
      const std::string bytes{'x', static_cast<char>(first), static_cast<char>(second), 'y'};
      ASSERT_EQ(firstNoText(printable(bytes)), std::nullopt) << first << " " << second;
    }
}

TEST(Shortened, InsideOfACharacter_CutsBeforeIt) {
  const std::string text = std::string(39, 'a') + "ü" + std::string(10, 'b');
  EXPECT_EQ(shortened(text), std::string(39, 'a') + "…");
}

} // namespace
} // namespace halfspace
