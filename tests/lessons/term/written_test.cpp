#include "lessons/term/written.h"

#include "tests/lessons/term/term_samples.h"

#include "lessons/term/plain_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace halfspace {
namespace {

using namespace test;

/// The number as text, with ≈ in front where it is rounded.
std::string text(const WrittenNumber &number) { return (number.exact ? "" : "≈ ") + plainText(number.term); }
std::string text(const Real &number) { return text(written(number)); }

Rational fraction(std::int64_t p, std::int64_t q) { return {p, q}; }

TEST(Written, OfFractions_HasTheSignInFront) {
  EXPECT_EQ(text(7), "7");
  EXPECT_EQ(text(0), "0");
  EXPECT_EQ(text(fraction(10, 4)), "5/2");
  EXPECT_EQ(text(fraction(-10, 3)), "−10/3");
  EXPECT_EQ(written(fraction(-10, 3)).term->kind, TermKind::Negation);
}

TEST(Written, OfDenominatorsAboveTwelve_IsADecimalWhereThatEnds) {
  EXPECT_EQ(text(fraction(1, 12)), "1/12");
  EXPECT_EQ(text(fraction(637, 100)), "6.37");
  EXPECT_EQ(text(fraction(-1, 16)), "−0.0625");
  EXPECT_EQ(text(fraction(5, 13)), "5/13");
}

TEST(Written, OfRoots_HasTheFactorInFront) {
  EXPECT_EQ(text(Surd::root(50)), "5√2");
  EXPECT_EQ(text(Surd::root(43)), "√43");
  EXPECT_EQ(text(Surd::root(43, fraction(2, 3))), "2√43/3");
  EXPECT_EQ(text(Surd::root(3, fraction(-1, 3))), "−√3/3");
  EXPECT_EQ(text(Surd::root(2) + Rational(1)), "1 + √2");
  EXPECT_EQ(text(Surd::root(2, -3) + fraction(-1, 2)), "−1/2 − 3√2");
}

TEST(Written, OfLongForms_IsRounded) {
  EXPECT_EQ(text(fraction(12'345'678'901'234, 1)), "12345678901234") << "fourteen characters";
  EXPECT_EQ(text(fraction(-12'345'678'901'234, 1)), "−12345678901234") << "the sign does not count";
  EXPECT_EQ(text(fraction(123'456'789'012'345, 1)), "≈ 1.23457·10¹⁴");
  EXPECT_EQ(text(fraction(1'000'003, 1'000'033)), "≈ 0.99997");
  EXPECT_EQ(text(Surd::root(101, fraction(10'007, 10'009))), "10007√101/10009");
  EXPECT_EQ(text(Surd::root(101, fraction(100'003, 10'009))), "≈ 100.411");
}

TEST(Written, OfADecimalThatWouldBeLong_StaysAFraction) {
  EXPECT_EQ(text(fraction(1, 4096)), "0.000244140625");
  EXPECT_EQ(text(fraction(1, 67'108'864)), "1/67108864") << "its decimal has 26 places";
}

TEST(Written, OfWhatIsBetweenBounds_IsRounded) {
  EXPECT_EQ(text(Real(Surd::root(2)) + Real(Surd::root(3))), "≈ 3.14626");
}

std::string text(const std::vector<Real> &list) {
  std::string all;
  for (const WrittenNumber &number : writtenAlike(list))
    all += (all.empty() ? "" : "; ") + text(number);
  return all;
}

TEST(WrittenAlike, OfSmallFractions_AreFractions) {
  EXPECT_EQ(text({fraction(1, 3), 2, fraction(-5, 2)}), "1/3; 2; −5/2");
  EXPECT_EQ(text({Surd::root(2), fraction(1, 2)}), "√2; 1/2");
}

TEST(WrittenAlike, WithADecimal_AreDecimalsWhereAllEnd) {
  EXPECT_EQ(text({fraction(637, 100), 2, fraction(-5, 2)}), "6.37; 2; −2.5");
}

TEST(WrittenAlike, WithADecimalAndAFractionThatNeverEnds_AreFractions) {
  EXPECT_EQ(text({fraction(637, 100), fraction(1, 3), 2}), "637/100; 1/3; 2");
  EXPECT_EQ(text({fraction(637, 100), Surd::root(2)}), "637/100; √2");
}

TEST(WrittenAlike, WithANumberThatMustBeRounded_AreDecimals) {
  EXPECT_EQ(text({fraction(1'000'003, 1'000'033), fraction(1, 3), fraction(1, 2), 2}),
            "≈ 0.99997; ≈ 0.333333; 0.5; 2");
}

TEST(WrittenAlike, InATermOfAList_AreItsNumbers) {
  const Term mixed = list({fraction(637, 100), fraction(1, 3), 2});
  EXPECT_EQ(plainText(mixed), "(637/100, 1/3, 2)");
  EXPECT_EQ(plainText(withParts(mixed, {fraction(637, 100), fraction(1, 2), 2})), "(6.37, 0.5, 2)");
  EXPECT_TRUE(showsRounded(list({fraction(1'000'003, 1'000'033), 2})));
}

TEST(Rounded, OfVeryLargeAndVerySmallNumbers_HasAPowerOfTen) {
  EXPECT_EQ(plainText(rounded(-6.02214076e23)), "−6.02214·10²³");
  EXPECT_EQ(plainText(rounded(0.650945, digitsAmongWords)), "0.6509");
  EXPECT_EQ(plainText(rounded(65094.6, digitsAmongWords)), "65095") << "no power of ten for that";
  EXPECT_EQ(plainText(rounded(6509450, digitsAmongWords)), "6.509·10⁶");
  EXPECT_EQ(plainText(rounded(1.5e-7)), "1.5·10⁻⁷");
  EXPECT_EQ(plainText(rounded(0.0001)), "0.0001");
}

TEST(Rounded, BeyondAllNumbers_IsInfinity) {
  EXPECT_EQ(plainText(rounded(std::numeric_limits<double>::infinity())), "∞");
  EXPECT_EQ(plainText(rounded(-std::numeric_limits<double>::infinity())), "−∞");
  EXPECT_EQ(text(powerOfTen(400)), "≈ ∞");
}

TEST(DecimalOf, ANumber_IsExactWhereSixDigitsAreAllOfIt) {
  EXPECT_EQ(text(decimalOf(fraction(-5, 2))), "−2.5");
  EXPECT_EQ(text(decimalOf(fraction(1, 3))), "≈ 0.333333");
  EXPECT_EQ(text(decimalOf(fraction(1'234'567, 1'000'000))), "≈ 1.23457");
  EXPECT_EQ(text(decimalOf(Surd::root(2))), "≈ 1.41421");
  EXPECT_EQ(text(decimalOf(0)), "0");
}

TEST(ShowsRounded, OfATerm_LooksIntoAllItsParts) {
  const Term longNumber = Rational(1'000'000'007, 3'000'000'019);
  EXPECT_TRUE(showsRounded(longNumber));
  EXPECT_TRUE(showsRounded(1 + root(list({2, 3 * longNumber}))));
  EXPECT_FALSE(showsRounded(root(2) / 3));
  EXPECT_FALSE(showsRounded(name(letter("x"), Rational(1'000'000'007, 3'000'000'019))))
      << "its digits are not shown";
}

} // namespace
} // namespace halfspace
