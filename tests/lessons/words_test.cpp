#include "lessons/words.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

/// Takes a catalogue out again when the test ends.
struct PluggedCatalogue {
  explicit PluggedCatalogue(Catalogue catalogue) { setCatalogue(std::move(catalogue)); }
  ~PluggedCatalogue() { setCatalogue({}); }
  PluggedCatalogue(const PluggedCatalogue &) = delete;
  PluggedCatalogue &operator=(const PluggedCatalogue &) = delete;
};

TEST(Words, WithoutACatalogue_AreEnglishWithTheirValues) {
  EXPECT_EQ(words("{t} is negative: {t}", {{"t", "t = −1"}}), "t = −1 is negative: t = −1");
}

TEST(Words, WithACatalogue_AreTranslatedBeforeTheyAreFilled) {
  const PluggedCatalogue german([](const char *english) {
    return std::string_view(english) == "{t} is negative" ? std::string("negativ: {t}")
                                                          : std::string(english);
  });
  EXPECT_EQ(words("{t} is negative", {{"t", "t = −1"}}), "negativ: t = −1");
  EXPECT_EQ(words("something else"), "something else");
}

TEST(Words, ABraceInAValue_IsNotFilledAgain) {
  EXPECT_EQ(words("{a}{b}", {{"a", "{b}"}, {"b", "x"}}), "{b}x");
}

TEST(Words, AnUnknownNameOrAnOpenBrace_Stays) { EXPECT_EQ(words("{who} {", {{"t", "1"}}), "{who} {"); }

} // namespace
} // namespace halfspace
