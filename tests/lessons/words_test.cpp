#include "lessons/words.h"
#include "tests/lessons/spoken_to_in.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

TEST(Words, WithoutACatalogue_AreEnglishWithTheirValues) {
  EXPECT_EQ(words("{t} is negative: {t}", {{"t", "t = −1"}}), "t = −1 is negative: t = −1");
}

TEST(Words, WithACatalogue_AreTranslatedBeforeTheyAreFilled) {
  const test::SpokenToIn german({[](const char *english) {
    return std::string_view(english) == "{t} is negative" ? std::string("negativ: {t}")
                                                          : std::string(english);
  }});
  EXPECT_EQ(words("{t} is negative", {{"t", "t = −1"}}), "negativ: t = −1");
  EXPECT_EQ(words("something else"), "something else");
}

TEST(Words, ABraceInAValue_IsNotFilledAgain) {
  EXPECT_EQ(words("{a}{b}", {{"a", "{b}"}, {"b", "x"}}), "{b}x");
}

TEST(Words, AnUnknownNameOrAnOpenBrace_Stays) { EXPECT_EQ(words("{who} {", {{"t", "1"}}), "{who} {"); }

} // namespace
} // namespace halfspace
