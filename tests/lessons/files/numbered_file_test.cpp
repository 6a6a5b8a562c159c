#include "lessons/files/numbered_file.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

std::string nameOf(const std::string &pattern, int number) {
  const auto file = parseNumberedFile(pattern);
  return file ? fileOf(*file, number) : "none";
}

TEST(NumberedFile, WithOnePlace_HasAtLeastSoManyDigits) {
  EXPECT_EQ(nameOf("frames/%04d.png", 7), "frames/0007.png");
  EXPECT_EQ(nameOf("frames/%04d.png", 12345), "frames/12345.png");
  EXPECT_EQ(nameOf("%d", 0), "0");
  EXPECT_EQ(nameOf("a%9db", 1), "a000000001b");
}

TEST(NumberedFile, WithoutOneOrWithSeveral_IsNone) {
  for (const char *pattern : {"", "a.png", "%", "%4", "%x.png", "%10d.png", "%99999999999999999999999d",
                              "%d%d", "%s", "%-4d", "%%d"})
    EXPECT_EQ(nameOf(pattern, 1), "none") << pattern;
}

} // namespace
} // namespace halfspace
