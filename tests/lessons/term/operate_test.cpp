// What operations come to: the laws of vectors, determinants and powers, and where there is nothing.
#include "lessons/term/operate.h"

#include "tests/geometry/random_numbers.h"
#include "tests/lessons/term/term_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace halfspace {
namespace {

using namespace test;

const Term t = unknown("t");
const Term u = unknown("u");
const Term v = list({1, 2, 2});

Term termOf(const ExactVec3 &vector) { return list({vector.x, vector.y, vector.z}); }

/// Whether both come to the same whatever their unknowns are.
bool areSame(const Term &a, const Term &b) {
  return a->value && b->value && areEqual(*a->value, *b->value) == true;
}

/// The sum over all orders of the columns, each with its sign.
Rational leibniz(const std::vector<Rational> &entries, std::size_t size) {
  std::vector<std::size_t> columns(size);
  std::iota(columns.begin(), columns.end(), 0U);
  Rational sum = 0;
  do {
    Rational part = 1;
    for (std::size_t row = 0; row < size; ++row) {
      part = part * entries[row * size + columns[row]];
      for (std::size_t before = 0; before < row; ++before)
        part = columns[before] > columns[row] ? Rational(-part) : part;
    }
    sum = sum + part;
  } while (std::next_permutation(columns.begin(), columns.end()));
  return sum;
}

class Determinants : public testing::TestWithParam<std::size_t> {};

TEST_P(Determinants, OfRandomRows_AreTheSumOverAllOrdersOfTheirColumns) {
  const std::size_t size = GetParam();
  RandomNumbers random(size);
  for (int i = 0; i < 30; ++i) {
    std::vector<Rational> entries(size * size);
    std::generate(entries.begin(), entries.end(), [&] { return random.rational(5); });
    const std::vector<Term> parts(entries.begin(), entries.end());
    EXPECT_TRUE(areSame(determinant(size, parts), leibniz(entries, size)));
  }
}

INSTANTIATE_TEST_SUITE_P(Rows, Determinants, testing::Values(1U, 2U, 3U, 4U));

TEST(DeterminantRows, OfARowTwice_AreZeroWithUnknownsToo) {
  for (std::size_t size = 2; size <= 4; ++size) {
    std::vector<Term> entries;
    for (std::size_t i = 0; i < size * size; ++i)
      entries.push_back(i % size == 0 ? t : u + static_cast<int>(i));
    std::copy_n(entries.begin(), size, entries.end() - static_cast<std::ptrdiff_t>(size));
    EXPECT_TRUE(areSame(determinant(size, entries), 0)) << size;
  }
}

TEST(CrossAndDot, OfRandomVectors_FulfilTheirLaws) {
  RandomNumbers random(4);
  for (int i = 0; i < 100; ++i) {
    const Term a = termOf(random.vector(9));
    const Term b = termOf(random.vector(9)) + t * termOf(random.vector(9));
    const Term c = termOf(random.vector(9));
    EXPECT_TRUE(areSame(cross(a, b), -cross(b, a)));
    EXPECT_TRUE(areSame(dot(cross(a, b), b), 0)) << "it is perpendicular to both";
    EXPECT_TRUE(areSame(cross(a, cross(b, c)), dot(a, c) * b - dot(a, b) * c));
    EXPECT_TRUE(areSame(dot(cross(a, b), cross(a, b)), dot(a, a) * dot(b, b) - power(dot(a, b), 2)));
    std::vector<Term> rows;
    for (const Term &row : {a, b, c})
      for (const Polynomial &entry : row->value->entries)
        rows.push_back(name(letter("x"), entry));
    EXPECT_TRUE(areSame(determinant(3, rows), dot(cross(a, b), c))) << "the volume of the box";
    EXPECT_TRUE(areSame(determinant(3, {a, b, c}), dot(cross(a, b), c))) << "rows or columns are the same";
  }
}

TEST(PermutedProduct, OfLines_IsZeroWhereTheyMeetAndTheirVolumeElsewhere) {
  RandomNumbers random(8);
  for (int i = 0; i < 100; ++i) {
    const Term point = termOf(random.vector(9));
    const Term gap = termOf(random.vector(9));
    const Term d1 = termOf(random.nonZeroVector(9));
    const Term d2 = termOf(random.nonZeroVector(9));
    EXPECT_TRUE(areSame(permuted(d1, cross(point, d1), d2, cross(point, d2)), 0));
    const Term other = point + gap;
    EXPECT_TRUE(areSame(permuted(d1, cross(point, d1), d2, cross(other, d2)), dot(gap, cross(d2, d1))));
  }
}

class Powers : public testing::TestWithParam<int> {};

TEST_P(Powers, OfNumbers_AreProductsAndBelowZeroTheirReciprocals) {
  const int exponent = GetParam();
  for (const Rational &base : {Rational(-3, 2), Rational(1), Rational(2), Rational(-1)}) {
    Rational expected = 1;
    for (int i = 0; i < std::abs(exponent); ++i)
      expected = expected * base;
    EXPECT_TRUE(areSame(power(base, exponent), exponent < 0 ? Rational(1 / expected) : expected));
  }
  EXPECT_EQ(power(0, exponent)->value.has_value(), exponent >= 0);
  EXPECT_EQ(power(t, exponent)->value.has_value(), exponent >= 0) << "nothing is divided by an unknown";
}

INSTANTIATE_TEST_SUITE_P(Exponents, Powers, testing::Values(-3, -1, 0, 1, 2, 5));

TEST(PowersOfSums, OfUnknowns_AreMultipliedOut) {
  EXPECT_TRUE(areSame(power(t + u, 2), t * t + 2 * t * u + u * u));
  EXPECT_TRUE(areSame(power(t - 1, 3), t * t * t - 3 * t * t + 3 * t - 1));
}

TEST(Norms, OfRandomVectors_ScaleWithTheMagnitudeOfTheFactor) {
  RandomNumbers random(6);
  for (int i = 0; i < 100; ++i) {
    const Term vector = termOf(random.vector(9));
    const Term factor = random.rational(9);
    EXPECT_TRUE(areSame(norm(factor * vector), norm(factor) * norm(vector)));
    EXPECT_TRUE(areSame(power(norm(vector), 2), dot(vector, vector)));
  }
}

TEST(Operations, ThatMakeNoSense_ComeToNothingAndSoDoesWhatIsMadeOfThem) {
  const std::vector<std::pair<const char *, Term>> operations{
      {"a number and a vector added", v + 1},
      {"vectors of different lengths added", v + list({1, 2})},
      {"vectors of different lengths multiplied", dot(v, list({1, 2}))},
      {"a dot product with a number", dot(v, 2)},
      {"a product of two vectors", product({v, 2, v})},
      {"a cross product in the plane", cross(list({1, 2}), list({3, 4}))},
      {"divided by a vector", Term(1) / v},
      {"divided by zero", v / (t - t)},
      {"divided by an unknown", Term(1) / t},
      {"a vector squared", power(v, 2)},
      {"the root of a vector", root(v)},
      {"the root below zero", root(-1)},
      {"the root of an unknown", root(t * t)},
      {"the magnitude of an unknown", norm(t)},
      {"a list in a list", list({v, 1})},
      {"a vector in a determinant", determinant(1, {v})},
      {"fewer columns than a column has numbers", determinant(2, {v, v})},
      {"a number for a column", determinant(3, {v, v, 1})},
      {"lines whose moment is a number", permuted(v, v, v, 1)}};
  for (const auto &[what, operation] : operations) {
    EXPECT_FALSE(operation->value) << what;
    EXPECT_FALSE((operation * 2)->value) << what;
  }
}

TEST(Operate, OnPartsThatLackOrAreLeaves_IsNothing) {
  EXPECT_FALSE(operate(TermKind::Sum, {}, 0));
  EXPECT_FALSE(operate(TermKind::Product, {Term(2), Term(1) / 0}, 0));
  EXPECT_FALSE(operate(TermKind::Unknown, {Term(1)}, 0)) << "a leaf is no operation";
  EXPECT_FALSE(operate(TermKind::Determinant, {1, 2, 3}, 2)) << "a row that is not whole";
  EXPECT_FALSE(operate(TermKind::Determinant, {1}, 0));
}

} // namespace
} // namespace halfspace
