// Numbers at the axes, from the very small to the very large.
#include "widgets/picture/labels/number_text.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

struct Written {
  double number;
  int exponent;
  const char *text;
};

void PrintTo(const Written &written, std::ostream *stream) {
  *stream << written.number << " e " << written.exponent;
}

struct NumberTexts : testing::TestWithParam<Written> {};

TEST_P(NumberTexts, OfANumberOnAStage_AreAsPeopleWriteIt) {
  EXPECT_EQ(numberText(GetParam().number, GetParam().exponent), GetParam().text);
}

INSTANTIATE_TEST_SUITE_P(AsDecimals, NumberTexts,
                         testing::Values(Written{5, 3, "5000"}, Written{-2.5, 1, "-25"},
                                         Written{5, -2, "0.05"}, Written{0, 9, "0"}, Written{12, 3, "12000"},
                                         Written{1234567, 0, "1234567"}, Written{0.25, -1, "0.025"}));

INSTANTIATE_TEST_SUITE_P(AsPowersOfTen, NumberTexts,
                         testing::Values(Written{2.5, 7, "2.5 \\cdot 10^{7}"},
                                         Written{10, 4, "1 \\cdot 10^{5}"},
                                         Written{-123, 4, "-1.23 \\cdot 10^{6}"},
                                         Written{5, -3, "5 \\cdot 10^{-3}"},
                                         Written{15, -20, "1.5 \\cdot 10^{-19}"}));

TEST(NumberText, OfTheLargestNumber_IsWrittenOut) { EXPECT_EQ(numberText(1e300).size(), 301U); }

} // namespace
} // namespace halfspace
