#include "lessons/term/operations.h"

#include "tests/lessons/term/term_samples.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

const Term a = name(vectorLetter("a"), ExactVec3(1, 2, 3));
const Term b = name(vectorLetter("b"), ExactVec3(4, 5, 6));
const Term c = name(vectorLetter("c"), ExactVec3(7, 8, 10));
const Term x = name(letter("x"), Rational(2));
const Term y = name(letter("y"), Rational(0));

Operations of(const Term &formula) { return OperationCounter().add(formula); }

TEST(Operations, OfNumbersAndVectors_AreThoseOfTheirNumbers) {
  EXPECT_EQ(of(a), Operations{});
  EXPECT_EQ(of(a - b), (Operations{.additions = 3}));
  EXPECT_EQ(of(a + x * b), (Operations{.multiplications = 3, .additions = 3}));
  EXPECT_EQ(of(dot(a, b)), (Operations{.multiplications = 3, .additions = 2}));
  EXPECT_EQ(of(cross(a, b)), (Operations{.multiplications = 6, .additions = 3}));
  EXPECT_EQ(of(x * y * a), (Operations{.multiplications = 4}));
  EXPECT_EQ(of(power(x, 3) / y), (Operations{.multiplications = 2, .divisions = 1}));
  EXPECT_EQ(of(a / x), (Operations{.divisions = 3}));
  EXPECT_EQ(of(-a), Operations{}) << "a turned sign costs nothing";
  EXPECT_EQ(of(root(x)), (Operations{.roots = 1}));
  EXPECT_EQ(of(norm(a)), (Operations{.multiplications = 3, .additions = 2, .roots = 1}));
  EXPECT_EQ(of(norm(x)), Operations{});
  EXPECT_EQ(of(permuted(a, b, b, c)), (Operations{.multiplications = 6, .additions = 5}));
}

TEST(Operations, OfADeterminant_AreThoseOfItsCofactors) {
  EXPECT_EQ(of(determinant(3, {a, b, c})), (Operations{.multiplications = 9, .additions = 5}));
  EXPECT_EQ(of(determinant(2, {x, y, y, x})), (Operations{.multiplications = 2, .additions = 1}));
}

TEST(Operations, OfAFormulaWithoutAValue_AreTheSame) {
  EXPECT_EQ(of(a / y - b), (Operations{.additions = 3, .divisions = 3}));
}

TEST(OperationCounter, CountsWhatReadsAlikeOnce) {
  OperationCounter counter;
  EXPECT_EQ(counter.add(power(dot(a, b), 2) - dot(a, b) * x),
            (Operations{.multiplications = 5, .additions = 3}));
  EXPECT_EQ(counter.add(dot(a, b) / x), (Operations{.divisions = 1}));
  EXPECT_EQ(counter.add(dot(a, b) / x), Operations{});
}

} // namespace
} // namespace halfspace
