#include "widgets/carriers/deflate.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

TEST(Deflate, InflatedAgain_IsTheSame_UpToTheLimitAndNoFurther) {
  for (const std::size_t length : {0U, 1U, 1000U, 200000U}) {
    const std::string content(length, 'x');
    const Inflated whole = inflated(deflated(content), length);
    EXPECT_TRUE(whole.isWhole) << length;
    EXPECT_EQ(whole.content, content);
    if (length == 0)
      continue;
    const Inflated more = inflated(deflated(content), length - 1);
    EXPECT_FALSE(more.isWhole) << length;
    EXPECT_EQ(more.content.size(), length);
  }
}

TEST(Deflate, OfVeryMuchInFewBytes_StopsAtTheLimit) {
  const std::string packed = deflated(std::string(64U << 20U, '\0'));
  EXPECT_LT(packed.size(), 100U << 10U);
  EXPECT_EQ(inflated(packed, 1000).content.size(), 1001U);
}

TEST(Deflate, Damaged_IsNotWhole) {
  const std::string packed = deflated("What was packed, and is damaged now.");
  for (std::size_t place = 0; place < packed.size(); ++place) {
    std::string damaged = packed;
    damaged[place] = static_cast<char>(damaged[place] ^ 1);
    const Inflated found = inflated(damaged, 1000);
    EXPECT_FALSE(found.isWhole && found.content != "What was packed, and is damaged now.") << place;
    EXPECT_FALSE(inflated(packed.substr(0, place), 1000).isWhole) << place;
  }
  EXPECT_TRUE(inflated(packed + "what follows", 1000).isWhole);
}

} // namespace
} // namespace halfspace
