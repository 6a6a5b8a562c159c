#include "lessons/object/point.h"
#include "lessons/reading/typed_number.h"

#include "lessons/lesson/typed_answer.h"
#include "lessons/scene/session_file.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

TEST(ParseMixed, OfAWholeNumberWithAFraction_IsTheirSum) {
  EXPECT_EQ(parseMixed("1 1/2"), Rational(3, 2));
  EXPECT_EQ(parseMixed("-3 1/3"), Rational(-10, 3));
  EXPECT_EQ(parseMixed(" −3  1 / 3 "), Rational(-10, 3));
  EXPECT_EQ(parseMixed("+0 2/4"), Rational(1, 2));
  EXPECT_EQ(parseMixed("- 2 1/2"), Rational(-5, 2));
}

TEST(ParseMixed, OfAnythingElse_IsNothing) {
  for (const char *text :
       {"", "1", "1/2", "1 2", "1 -1/2", "1 1/0", "1.5 1/2", "1 1.5/2", "x 1/2", "1 1/2 1/2"})
    EXPECT_FALSE(parseMixed(text)) << text;
}

TEST(PlainSpelling, OfWhatPeopleType_IsThatOfFiles) {
  EXPECT_EQ(plainSpelling(" +1 1/2 "), "3/2");
  EXPECT_EQ(plainSpelling("− 10 / 3"), "-10/3");
  EXPECT_EQ(plainSpelling("1 234.5"), "1234.5");
  EXPECT_EQ(plainSpelling("-,5", ','), "-0.5");
  EXPECT_EQ(plainSpelling("1 1/0"), "11/0") << "no number in either spelling";
}

TEST(MixedNumbers, InBlanksAndSetValues_AreMixedNumbers) {
  EXPECT_TRUE(readAnswer("-3 1/3")->means(Surd(Rational(-10, 3))));
  const Session session{"", 0, {{{"Q", PointObject{}}}}};
  const auto moved = withValue(session, "Q=1 1/2,-3 1/3,2");
  ASSERT_TRUE(moved);
  EXPECT_EQ(objectAs<PointObject>(*findObject(moved->scene, "Q"))->at,
            ExactVec3(Rational(3, 2), Rational(-10, 3), 2));
}

} // namespace
} // namespace halfspace
