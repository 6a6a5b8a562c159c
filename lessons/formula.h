// Numbers as LaTeX, and formulas that know whether they are still exact.
#pragma once

#include "geometry/plane.h"
#include "geometry/surd.h"
#include "lessons/object.h"

#include <string>

namespace halfspace {

/// A number as it is written for a learner.
struct ShownNumber {
  std::string latex;
  bool exact =
      true; ///< false: rounded to `shownDigits` significant digits, because the exact form is too long
};

/// Exact forms of more characters than this, not counting those of `*sqrt()`, are shown rounded.
inline constexpr std::size_t longestExactForm = 14;
inline constexpr int shownDigits = 6;

[[nodiscard]] ShownNumber show(const Rational &value);
[[nodiscard]] ShownNumber show(const Surd &value);

/// The value rounded to `shownDigits` significant digits, as a decimal.
[[nodiscard]] std::string roundedText(double value);

/// Builds one piece of a worked line. It remembers whether a number in it was rounded, so that the piece
/// begins with
/// `=` only when every number that it shows is exact.
class Formula {
public:
  [[nodiscard]] std::string operator()(const Rational &value);
  [[nodiscard]] std::string operator()(const Surd &value);
  /// (x, y, z)
  [[nodiscard]] std::string operator()(const ExactVec3 &value);
  /// (a, b, c, d)
  [[nodiscard]] std::string list(const std::vector<Surd> &values);
  /// In parentheses when it is negative: what may stand after an operator.
  [[nodiscard]] std::string factor(const Rational &value);
  /// 5^2, (-5)^2: in parentheses wherever the exponent would stick to a part of the number only.
  [[nodiscard]] std::string squared(const Rational &value);
  /// ` + 5`, ` - 5`; nothing for 0.
  [[nodiscard]] std::string addend(const Rational &value);
  /// 3·4 + (−1)·2 + 0·5: a dot product with its numbers put in.
  [[nodiscard]] std::string products(const ExactVec3 &a, const ExactVec3 &b);
  /// (p/q) as a tall fraction with the numbers as they are, not reduced.
  [[nodiscard]] std::string quotient(const Surd &p, const Surd &q);
  /// ax + by + cz + d without zero terms, 0 when all are zero. A coefficient goes with the variable at its
  /// place (LaTeX); those beyond the last variable stand alone.
  [[nodiscard]] std::string linear(const std::vector<Surd> &coefficients,
                                   const std::vector<std::string> &variables);

  /// The body after `=` or, when a number in it was rounded, after `\approx`.
  [[nodiscard]] std::string equals(const std::string &body) const;

private:
  bool m_exact = true;
};

/// A number or vector after `=`, or after `\approx` when it was rounded: a line's result.
template <class Value> [[nodiscard]] std::string equalTo(const Value &value) {
  Formula f;
  std::string body = f(value);
  return f.equals(body);
}

/// `\mark{id}{latex}`
[[nodiscard]] std::string marked(std::string_view id, std::string_view latex);

/// The value in plain text for a sentence: `t = −10/3`, or `t ≈ 0.271828` when it is rounded.
[[nodiscard]] std::string equation(std::string_view name, const Surd &value);

[[nodiscard]] std::string equation(std::string_view name, const ExactVec3 &value);

/// The a, b, c, d of the plane's equation ax + by + cz + d = 0.
[[nodiscard]] std::vector<Surd> coefficientsOf(const Plane<Rational> &plane);

/// The coordinates as a list of values.
[[nodiscard]] std::vector<Surd> listOf(const ExactVec3 &value);

} // namespace halfspace
