// Formulas as they are typed, and what they come to.
#include "lessons/formula/read_formula.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace halfspace {
namespace {

const std::map<std::string, FormulaValue, std::less<>> named{
    {"k", Rational(3, 2)},     {"m", Rational(-2)},        {"zero", Rational(0)},
    {"A", ExactVec3{1, 2, 3}}, {"B", ExactVec3{5, 0, -1}}, {"E.n", ExactVec3{0, 0, 2}}};

std::optional<FormulaValue> valueNamed(std::string_view name) {
  const auto found = named.find(name);
  return found == named.end() ? std::nullopt : std::optional(found->second);
}

std::optional<FormulaShape> shapeNamed(std::string_view name) {
  const auto value = valueNamed(name);
  if (!value)
    return {};
  return std::holds_alternative<Rational>(*value) ? FormulaShape::Number : FormulaShape::Triple;
}

Formula formulaOf(std::string_view text, char decimalMark = '.') {
  auto read = readFormula(text, decimalMark);
  const auto *fault = std::get_if<FormulaFault>(&read);
  EXPECT_FALSE(fault) << text << ": " << fault->sentence << " at " << fault->at;
  return fault ? Formula() : std::get<Formula>(std::move(read));
}

FormulaValue valueOf(std::string_view text, char decimalMark = '.') {
  const Formula formula = formulaOf(text, decimalMark);
  EXPECT_TRUE(std::holds_alternative<FormulaShape>(shapeOf(formula, shapeNamed))) << text;
  return std::get<FormulaValue>(valueOf(formula, valueNamed));
}

/// Where a text is no formula, or does not fit, or has no value.
std::optional<std::size_t> faultIn(std::string_view text) {
  const auto read = readFormula(text);
  if (const auto *fault = std::get_if<FormulaFault>(&read))
    return fault->at;
  const auto shape = shapeOf(std::get<Formula>(read), shapeNamed);
  if (const auto *fault = std::get_if<FormulaFault>(&shape))
    return fault->at;
  const auto value = valueOf(std::get<Formula>(read), valueNamed);
  if (const auto *fault = std::get_if<FormulaFault>(&value))
    return fault->at;
  return {};
}

TEST(Formula, OfNumbers_IsExact) {
  for (const auto &[text, value] : {std::pair("3/2", Rational(3, 2)),
                                    {"-3 1/3", Rational(-10, 3)},
                                    {"−3 1/3", Rational(-10, 3)},
                                    {"1.5", Rational(3, 2)},
                                    {"2k", Rational(3)},
                                    {"2 k + m", Rational(1)},
                                    {"-k^2", Rational(-9, 4)},
                                    {"(-k)²", Rational(9, 4)},
                                    {"1/2k", Rational(3, 4)},
                                    {"2 - 3 - 4", Rational(-5)},
                                    {"8/4/2", Rational(1)},
                                    {"k*m/3", Rational(-1)},
                                    {"2·3", Rational(6)},
                                    {"A · B", Rational(2)},
                                    {"A.x + A.z", Rational(4)},
                                    {"E.n.z", Rational(2)}})
    EXPECT_EQ(std::get<Rational>(valueOf(text)), value) << text;
}

TEST(Formula, OfPointsAndVectors_IsExact) {
  for (const auto &[text, value] : {std::pair("(1, 2k, m)", ExactVec3(1, 3, -2)),
                                    {"(A + B)/2", ExactVec3(3, 1, 1)},
                                    {"B − A", ExactVec3(4, -2, -4)},
                                    {"2A", ExactVec3(2, 4, 6)},
                                    {"A*k", ExactVec3(Rational(3, 2), 3, Rational(9, 2))},
                                    {"k·A", ExactVec3(Rational(3, 2), 3, Rational(9, 2))},
                                    {"A × B", ExactVec3(-2, 16, -10)},
                                    {"-A", ExactVec3(-1, -2, -3)},
                                    {"A + 1/2 E.n", ExactVec3(1, 2, 4)}})
    EXPECT_EQ(std::get<ExactVec3>(valueOf(text)), value) << text;
}

TEST(Formula, WithADecimalComma_PartsByWhatIsNoDecimal) {
  const ExactVec3 value{Rational(3, 2), 3, 2};
  for (const char *text : {"(1,5; 3; 2)", "(1,5, 3, 2)"})
    EXPECT_EQ(std::get<ExactVec3>(valueOf(text, ',')), value) << text;
  EXPECT_EQ(std::get<ExactVec3>(valueOf("(1,2,3)", ',')), ExactVec3(1, 2, 3));
  EXPECT_EQ(toText(formulaOf("(1,2,3)", ','), ','), "(1; 2; 3)");
}

TEST(Formula, ThatIsWrong_SaysWhere) {
  for (const auto &[text, at] : {std::pair("2 +", 3U),
                                 {"(1, 2)", 0U},
                                 {"(1, 2, 3", 8U},
                                 {"2 3", 2U},
                                 {"k # 2", 2U},
                                 {"2 + nobody", 4U},
                                 {"k + A", 4U},
                                 {"A B", 0U},
                                 {"1/A", 2U},
                                 {"A^2", 0U},
                                 {"k.x", 0U},
                                 {"k × A", 0U},
                                 {"(1, A, 2)", 4U},
                                 {"1/zero", 2U},
                                 {"k^99", 1U},
                                 {"", 0U}}) {
    const auto fault = faultIn(text);
    ASSERT_TRUE(fault) << text;
    EXPECT_EQ(*fault, at) << text;
  }
}

TEST(Formula, OfAnyLengthAndDepth_IsBounded) {
  EXPECT_TRUE(std::holds_alternative<FormulaFault>(readFormula(std::string(longestFormula + 1, '1'))));
  for (const std::string &text : {std::string(longestFormula, '('), std::string(longestFormula, '-')})
    EXPECT_TRUE(std::holds_alternative<FormulaFault>(readFormula(text)));
}

/// Formulas of every kind, so deep at most.
class RandomFormulas {
public:
  explicit RandomFormulas(unsigned seed) : m_random(seed) {}

  Formula next(int depth) {
    using enum FormulaKind;
    static constexpr std::array kinds{Number,     Name,    Component, Triple, Negative, Sum,
                                      Difference, Product, Quotient,  Power,  Dot,      Cross};
    const FormulaKind kind = depth == 0 ? kinds.at(pick(2)) : kinds.at(pick(kinds.size()));
    switch (kind) {
    case Number:
      return {Number, Rational(static_cast<int>(pick(40)) - 20, static_cast<int>(pick(3)) + 1)};
    case Name:
      return {Name, {}, std::array{"k", "A", "B", "E.n", "m"}.at(pick(5))};
    case Component:
      return {Component, static_cast<int>(pick(3)), {}, {{Name, {}, "A"}}};
    case Triple:
      return {Triple, {}, {}, {next(depth - 1), next(depth - 1), next(depth - 1)}};
    case Negative:
      return negative(next(depth - 1));
    case Power:
      return {Power, {}, {}, {next(depth - 1), {Number, static_cast<int>(pick(4))}}};
    case Quotient:
      return quotient(next(depth - 1), next(depth - 1));
    default:
      return {kind, {}, {}, {next(depth - 1), next(depth - 1)}};
    }
  }

private:
  std::size_t pick(std::size_t count) { return m_random() % count; }
  /// A fraction of two numbers is a number.
  static Formula quotient(Formula above, Formula below) {
    if (isPlainNumber(above) && isPlainNumber(below) && below.number != 0)
      return {FormulaKind::Number, above.number / below.number};
    return {FormulaKind::Quotient, {}, {}, {std::move(above), std::move(below)}};
  }
  /// A number takes its sign itself.
  static Formula negative(Formula part) {
    if (isPlainNumber(part))
      return {FormulaKind::Number, -part.number};
    return {FormulaKind::Negative, {}, {}, {std::move(part)}};
  }

  std::mt19937 m_random;
};

TEST(Formula, WrittenAndReadAgain_IsTheSame) {
  RandomFormulas formulas(7);
  int read = 0;
  int valued = 0;
  for (int i = 0; i < 20000; ++i) {
    const Formula formula = formulas.next(4);
    for (const char mark : {'.', ','}) {
      const std::string text = toText(formula, mark);
      if (text.size() > longestFormula)
        continue;
      ++read;
      const auto again = readFormula(text, mark);
      ASSERT_TRUE(std::holds_alternative<Formula>(again))
          << text << ": " << std::get<FormulaFault>(again).sentence << " "
          << std::get<FormulaFault>(again).at;
      ASSERT_TRUE(std::get<Formula>(again) == formula) << text << " | " << toText(std::get<Formula>(again));
      if (std::holds_alternative<FormulaFault>(shapeOf(formula, shapeNamed)))
        continue;
      const auto value = valueOf(formula, valueNamed);
      const auto valueAgain = valueOf(std::get<Formula>(again), valueNamed);
      ASSERT_EQ(value.index(), valueAgain.index()) << text;
      if (std::holds_alternative<FormulaValue>(value)) {
        ++valued;
        ASSERT_EQ(std::get<FormulaValue>(value), std::get<FormulaValue>(valueAgain)) << text;
      }
    }
  }
  EXPECT_GT(read, 20000);
  EXPECT_GT(valued, 1000);
}

TEST(Formula, WithOtherNames_SpeaksOfOthers) {
  Formula formula = formulaOf("2k + A · E.n");
  std::vector<std::string> names;
  forEachName(formula, [&](std::string &name) {
    names.push_back(name);
    name += "_1";
  });
  EXPECT_EQ(names, (std::vector<std::string>{"k", "A", "E.n"}));
  EXPECT_EQ(toText(formula), "2k_1 + A_1 · E.n_1");
}

TEST(Formula, OfTheShortestVector_HasWholeNumbersWithoutACommonFactor) {
  EXPECT_EQ(valueOf("shortest((0, 0, 25))"), FormulaValue(ExactVec3(0, 0, 1)));
  EXPECT_EQ(valueOf("shortest(-1/2, 3/4, 0)"), FormulaValue(ExactVec3(-2, 3, 0)));
  EXPECT_EQ(valueOf("shortest(A - A)"), FormulaValue(ExactVec3(0)));
  EXPECT_EQ(toText(formulaOf("shortest( (B-A) × E.n )")), "shortest((B - A) × E.n)");
  EXPECT_TRUE(std::holds_alternative<FormulaFault>(shapeOf(formulaOf("shortest(k)"), shapeNamed)));
}

} // namespace
} // namespace halfspace
