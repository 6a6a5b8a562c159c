// Terms that several tests begin with, terms at random, and what they come to as text.
#pragma once

#include "lessons/object/object.h"
#include "lessons/term/term.h"

#include <random>

namespace halfspace::test {

[[nodiscard]] inline std::string textOf(const Real &number) {
  return number.exact() ? toText(*number.exact()).value_or("not canonical") : "between bounds";
}

/// 2t t - 3x + 1: factors in the program's order, so that a test sees it.
[[nodiscard]] inline std::string textOf(const Polynomial &polynomial) {
  std::string text;
  for (const Polynomial::Summand &summand : polynomial.summands()) {
    text += text.empty() ? "" : " + ";
    text += textOf(summand.factor);
    for (const std::string &letter : summand.monomial)
      text += " " + letter;
  }
  return text.empty() ? textOf(polynomial.constant()) : text + " + " + textOf(polynomial.constant());
}

/// The value as text: 3/2, (1, 2, 3), nothing.
[[nodiscard]] inline std::string valueText(const Term &term) {
  if (!term->value)
    return "nothing";
  std::string text;
  for (const Polynomial &entry : term->value->entries)
    text += (text.empty() ? "" : ", ") + textOf(entry);
  return term->value->isList ? "(" + text + ")" : text;
}

/// The point–plane example of the notes.
struct NoteTerms {
  Term P0 = given(letter("P", "0"), {5, 4, 7}, "E", 0).marked("P0");
  Term n = given(vectorLetter("n"), {1, 2, 2}, "E", 1).marked("n");
  Term Q = given(letter("Q"), {11, 15, 8}, "Q", 0).marked("Q");
  Term f = applied(letter("f"), Q, Rational(30));
};

/// Terms without a pattern: every operation of numbers and vectors, in any depth. Some come to nothing,
/// because they divide by zero or take the root of a negative number.
class RandomTerms {
public:
  explicit RandomTerms(std::uint64_t seed, bool withUnknowns = false)
      : m_engine(seed), m_withUnknowns(withUnknowns) {}

  /// What the unknown t is set to where a number is needed.
  [[nodiscard]] static Rational unknownValue() { return {137, 11}; }

  [[nodiscard]] Term number(int depth) {
    if (depth == 0)
      return numberLeaf();
    const auto next = [&] { return number(integer(0, depth - 1)); };
    switch (integer(0, 9)) {
    case 0:
      return next() + next();
    case 1:
      return next() - next();
    case 2:
      return sum({next(), -next(), next()});
    case 3:
      return next() * next();
    case 4:
      return next() / next();
    case 5:
      return power(next(), integer(2, 3));
    case 6:
      return root(integer(0, 1) == 0 ? power(next(), 2) : next());
    case 7:
      return -next();
    case 8:
      return integer(0, 3) == 0 ? norm(next()) : norm(vector(depth - 1));
    default:
      return dot(vector(depth - 1), vector(depth - 1));
    }
  }

  [[nodiscard]] Term vector(int depth) {
    if (depth == 0)
      return vectorLeaf();
    const auto next = [&] { return vector(integer(0, depth - 1)); };
    switch (integer(0, 6)) {
    case 0:
      return list({number(depth - 1), number(depth - 1), number(depth - 1)});
    case 1:
      return next() + next();
    case 2:
      return next() - next();
    case 3:
      return number(depth - 1) * next();
    case 4:
      return next() / number(depth - 1);
    case 5:
      return cross(next(), next());
    default:
      return -next();
    }
  }

private:
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(m_engine); }

  Term numberLeaf() {
    switch (integer(0, m_withUnknowns ? 7 : 6)) {
    case 0:
      return Rational(integer(-20, 20), integer(1, 12));
    case 1:
      return Rational(integer(-999, 999), 100);
    case 2:
      return Surd::root(integer(2, 7), Rational(integer(-6, 6), integer(1, 3)));
    case 3:
      return Surd::root(integer(2, 3), integer(1, 4)) + Rational(integer(-3, 3));
    case 4:
      return name(letter("p"), Rational(3, 4));
    case 5:
      return integer(0, 1) == 0 ? name(letter("q"), Rational(-5))
                                : applied(letter("f"), name(letter("Q"), ExactVec3(1, 1, 1)), Rational(-24));
    case 7:
      return unknown("t");
    default:
      return integer(-9, 9);
    }
  }

  Term vectorLeaf() {
    switch (integer(0, 3)) {
    case 0:
      return name(vectorLetter("u"), ExactVec3(4, -8, 0)).marked("u");
    case 1:
      return name(vectorLetter("v"), ExactVec3(1, 2, 2));
    case 2:
      return given(letter("P", "0"), {-5, 4, 7}, "E", 0);
    default:
      return list({integer(-9, 9), integer(-9, 9), integer(-9, 9)});
    }
  }

  std::mt19937_64 m_engine;
  bool m_withUnknowns;
};

} // namespace halfspace::test
