#include "lessons/object/kinds/point.h"
#include "lessons/reading/typed_number.h"

#include "lessons/reading/typed_answer.h"
#include "lessons/scene/file/session_file.h"
#include "tests/geometry/random_numbers.h"

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
  EXPECT_EQ(plainSpelling("–10⁄3"), "-10/3") << "a dash, and the slash of text programs";
  EXPECT_EQ(plainSpelling("1 234.5"), "1234.5");
  EXPECT_EQ(plainSpelling("-,5", ','), "-0.5");
  EXPECT_EQ(plainSpelling("1 1/0"), "11/0") << "no number in either spelling";
}

/// As people write it who avoid improper fractions: −3 1/3.
std::string mixedText(const Rational &value) {
  const auto [numerator, below] = *value.words();
  const std::int64_t above = std::abs(numerator);
  return (value < 0 ? "-" : "") + std::to_string(above / below) + " " + std::to_string(above % below) + "/" +
         std::to_string(below);
}

TEST(TypedNumbers, InEverySpelling_AreTheSame) {
  RandomNumbers random(3);
  for (int i = 0; i < 300; ++i) {
    const Rational value = random.rational(50);
    const std::string exact = toText(value);
    EXPECT_EQ(parseRational(plainSpelling(exact)), value) << exact;
    EXPECT_EQ(parseRational(plainSpelling(" " + exact + " ")), value) << exact;
    if (value < 0) {
      EXPECT_EQ(parseRational(plainSpelling("−" + exact.substr(1))), value) << exact;
    } else {
      EXPECT_EQ(parseRational(plainSpelling("+" + exact)), value) << exact;
    }
    EXPECT_EQ(parseMixed(mixedText(value)), value) << mixedText(value);
    EXPECT_EQ(parseRational(plainSpelling(mixedText(value))), value) << mixedText(value);
  }
}

TEST(TypedNumbers, WithADecimalComma_AreReadOnlyWhereThatIsTheMark) {
  EXPECT_EQ(parseRational(plainSpelling("1,25", ',')), Rational(5, 4));
  EXPECT_FALSE(parseRational(plainSpelling("1,25")));
  EXPECT_EQ(parseRational(plainSpelling("1.25", ',')), Rational(5, 4)) << "as in files";
  EXPECT_FALSE(parseRational(plainSpelling("1,2,5", ',')));
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
