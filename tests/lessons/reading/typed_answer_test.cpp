#include "lessons/reading/typed_answer.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

Surd root(int square, const Rational &factor = 1) { return Surd::root(square, factor); }

TEST(TypedAnswer, OfWhatBoundsLeaveOpen_IsRightAsFarAsAnybodyCanType) {
  const Real onePlusRoot = squareRoot(Real(root(2, 2) + Rational(3))).value(); // √(3 + 2√2) = 1 + √2
  const TermValue zero = onePlusRoot - Real(root(2) + Rational(1));
  EXPECT_TRUE(readAnswer("0")->means(zero));
  EXPECT_FALSE(readAnswer("0.001")->means(zero));
  EXPECT_TRUE(readAnswer("1 + √2")->means(onePlusRoot));
  EXPECT_FALSE(readAnswer("2√2")->means(onePlusRoot));
}

TEST(ReadAnswer, OfNumbersAsLearnersWriteThem_IsExact) {
  const std::vector<std::pair<const char *, Surd>> cases{{"10", 10},
                                                         {" -10 / 3 ", Rational(-10, 3)},
                                                         {"−10/3", Rational(-10, 3)},
                                                         {"–10⁄3", Rational(-10, 3)},
                                                         {"10÷3", Rational(10, 3)},
                                                         {"10/-3", Rational(-10, 3)},
                                                         {"3.25", Rational(13, 4)},
                                                         {"2*sqrt(43)/3", root(43, Rational(2, 3))},
                                                         {"(2√43)/3", root(43, Rational(2, 3))},
                                                         {"2/3·√43", root(43, Rational(2, 3))},
                                                         {"-sqrt43", root(43, -1)},
                                                         {"30/√43", root(43, Rational(30, 43))},
                                                         {"√(4/9)", Rational(2, 3)},
                                                         {"√2√3", root(6)},
                                                         {"1 - 2√2", root(2, -2) + Rational(1)},
                                                         {"(1+√2)*2", root(2, 2) + Rational(2)}};
  for (const auto &[text, value] : cases) {
    const auto parsed = readAnswer(text);
    ASSERT_TRUE(parsed) << text;
    EXPECT_TRUE(parsed->means(value)) << text;
  }
}

TEST(ReadAnswer, WithADecimalComma_TellsItFromOneThatParts) {
  const auto list = [](std::vector<Polynomial> entries) { return TermValue::list(std::move(entries)); };
  const Polynomial half(Real(Rational(3, 2)));
  const Polynomial two(Real(2));
  const Polynomial three(Real(3));
  EXPECT_TRUE(readAnswer("1,5", ',')->means(Surd(Rational(3, 2))));
  EXPECT_TRUE(readAnswer("1.5", ',')->means(Surd(Rational(3, 2))));
  EXPECT_TRUE(readAnswer("(3, 2)", ',')->means(list({three, two})));
  for (const char *text : {"(2, 3, 2)", "(2,3,2)", "(2; 3; 2)", "2, 3, 2"})
    EXPECT_TRUE(readAnswer(text, ',')->means(list({two, three, two}))) << text;
  for (const char *text : {"(1,5; 3; 2)", "(1,5, 3, 2)"})
    EXPECT_TRUE(readAnswer(text, ',')->means(list({half, three, two}))) << text;
  EXPECT_TRUE(readAnswer("x + 1,5y = 2", ',')->isEquation);
  EXPECT_FALSE(readAnswer("1,,,5", ','));
}

TEST(ReadAnswer, WhereSeveralNumbersAreAskedFor_NeedsNoCommas) {
  const TermValue list = TermValue::list(
      {Polynomial(Real(1)), Polynomial(Real(Rational(-2, 3))), Polynomial(Real(Rational(5, 2)))});
  for (const char *text : {"1 -2/3 2.5", "(1 -2/3 2.5)", "  1  −2/3   5/2 ", "1, -2/3, 2.5"})
    EXPECT_TRUE(readAnswer(text, '.', 3) && readAnswer(text, '.', 3)->means(list)) << text;
  EXPECT_TRUE(readAnswer("1 -2/3 2,5", ',', 3)->means(list));
  EXPECT_FALSE(readAnswer("1 -2 - 3", '.', 3)->isList) << "a difference";
  EXPECT_FALSE(readAnswer("1 2", '.', 3)) << "too few";
  EXPECT_TRUE(readAnswer("1 -2 -3")->means(Surd(-4))) << "one number is asked for";
}

TEST(ReadAnswer, OfAnythingElse_IsNothing) {
  for (const char *text : {"", "-", "1/0", "1/x", "1/√0", "√-2", "√", "3..5", "2*", "(2", "2)", "1+", "√2+√3",
                           "√√2", "√x", "1,,2", "_"})
    EXPECT_FALSE(readAnswer(text)) << text;
  EXPECT_FALSE(readAnswer(std::string(longestAnswer + 1, '1')));
}

TEST(ReadAnswer, OfNestedParentheses_EndsAtTheBoundOfItsLength) {
  const std::string deep = std::string(59, '(') + "1" + std::string(59, ')');
  EXPECT_TRUE(readAnswer(deep)->means(Surd(1)));
  EXPECT_TRUE(readAnswer(std::string(longestAnswer - 1, '-') + "1"));
}

TEST(ReadAnswer, OfProductsThatGrowWithoutEnd_IsNothing) {
  std::string sums;
  for (char letter = 'a'; letter < 'x'; letter = static_cast<char>(letter + 2))
    sums += std::string("(") + letter + "+" + static_cast<char>(letter + 1) + ")";
  ASSERT_LT(sums.size(), longestAnswer);
  EXPECT_FALSE(readAnswer(sums));
}

TEST(ReadAnswer, OfNumbersAsFieldsTakeThem_IsTheSame) {
  EXPECT_TRUE(readAnswer(".5")->means(Surd(Rational(1, 2))));
  EXPECT_TRUE(readAnswer("+5")->means(Surd(5)));
  EXPECT_FALSE(readAnswer("10 3")) << "103, 10·3 or 10 and 3?";
  EXPECT_FALSE(readAnswer("x + 3 1/3 = 0")) << "not 31/3";
}

TEST(ReadAnswer, OfADifference_IsNotRounded) {
  EXPECT_FALSE(readAnswer("1-0.5")->means(Surd(Rational(47, 100))));
  EXPECT_TRUE(readAnswer("-0.33")->means(Surd(Rational(-1, 3))));
}

TEST(ReadAnswer, OfAnEquation_IsItsLeftSideLessItsRight) {
  const auto answer = readAnswer("2x = y - 3");
  ASSERT_TRUE(answer);
  EXPECT_TRUE(answer->isEquation);
  const Polynomial x = Polynomial::unknown("x");
  const Polynomial y = Polynomial::unknown("y");
  EXPECT_TRUE(answer->means(x + x - y + Polynomial(Real(3))));
  EXPECT_TRUE(answer->meansEquation(y - x - x - Polynomial(Real(3)))) << "its negative";
  EXPECT_FALSE(answer->meansEquation(y - x - Polynomial(Real(3))));
  EXPECT_FALSE(readAnswer("x = y = 1"));
  EXPECT_FALSE(readAnswer("= 1"));
}

TEST(ReadAnswer, OfADecimal_MeansWhatRoundsToIt) {
  EXPECT_TRUE(readAnswer("3.33")->means(Surd(Rational(10, 3))));
  EXPECT_FALSE(readAnswer("3.34")->means(Surd(Rational(10, 3))));
  EXPECT_FALSE(readAnswer("0.3")->means(Surd(Rational(1, 3)))) << "too short to be rounded";
}

} // namespace
} // namespace halfspace
