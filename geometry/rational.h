// Exact numbers: fractions of any size.
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <iosfwd>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace halfspace {

/// A fraction in lowest terms with a positive denominator, of any size.
/// (1) Sums, differences, products, quotients and comparisons are exact.
/// (2) Equal values have the same numerator, denominator and text, however they were come by.
/// (3) `words` is set exactly where numerator and denominator are at most 2^63 − 1 in magnitude.
///
/// Nearly all that a lesson or a question computes with fits two machine words and is kept in them; only what
/// does not is handed to GMP, or to Boost where it is built without. A small sum or product costs some
/// nanoseconds and no memory.
class Rational {
public:
  Rational() = default;
  template <std::integral Int>
  Rational(Int value) { // NOLINT(google-explicit-constructor): every integer is a fraction
    static_assert(sizeof(Int) <= sizeof(std::int64_t));
    if (std::in_range<std::int64_t>(value) &&
        std::cmp_not_equal(value, std::numeric_limits<std::int64_t>::min()))
      m_numerator = static_cast<std::int64_t>(value);
    else
      *this = beyondWords(std::cmp_less(value, 0), static_cast<std::uint64_t>(value));
  }
  /// p/q. Requires q ≠ 0.
  template <std::integral P, std::integral Q> Rational(P p, Q q) { *this = Rational(p) / Rational(q); }

  /// The same value as Boost knows it: `geometry/integer.h` says what that is. Few need it, and it takes
  /// seconds to compile.
  struct Big;
  explicit Rational(Big value);
  [[nodiscard]] Big big() const;

  /// Whole numbers, the denominator a positive one.
  [[nodiscard]] Rational numerator() const;
  [[nodiscard]] Rational denominator() const;
  [[nodiscard]] bool isInteger() const;
  /// −1, 0 or 1.
  [[nodiscard]] int sign() const;

  [[nodiscard]] Rational operator-() const;
  Rational &operator+=(const Rational &other) { return *this = *this + other; }
  Rational &operator-=(const Rational &other) { return *this = *this - other; }
  Rational &operator*=(const Rational &other) { return *this = *this * other; }
  Rational &operator/=(const Rational &other) { return *this = *this / other; }

  [[nodiscard]] friend Rational operator+(const Rational &a, const Rational &b) {
    std::int64_t sum = 0;
    if (a.isSmallInteger() && b.isSmallInteger() &&
        !__builtin_add_overflow(a.m_numerator, b.m_numerator, &sum))
      return sum;
    return a.plus(b);
  }
  [[nodiscard]] friend Rational operator-(const Rational &a, const Rational &b) {
    std::int64_t difference = 0;
    if (a.isSmallInteger() && b.isSmallInteger() &&
        !__builtin_sub_overflow(a.m_numerator, b.m_numerator, &difference))
      return difference;
    return a.plus(-b);
  }
  [[nodiscard]] friend Rational operator*(const Rational &a, const Rational &b) {
    std::int64_t product = 0;
    if (a.isSmallInteger() && b.isSmallInteger() &&
        !__builtin_mul_overflow(a.m_numerator, b.m_numerator, &product))
      return product;
    return a.times(b);
  }
  /// Requires b ≠ 0, as all fractions do: debug builds stop at a division by zero.
  [[nodiscard]] friend Rational operator/(const Rational &a, const Rational &b) { return a.over(b); }

  [[nodiscard]] friend bool operator==(const Rational &a, const Rational &b) {
    return a.isSmall() && b.isSmall() ? a.m_numerator == b.m_numerator && a.m_denominator == b.m_denominator
                                      : std::is_eq(a <=> b);
  }
  [[nodiscard]] friend std::strong_ordering operator<=>(const Rational &a, const Rational &b) {
    return a.isSmallInteger() && b.isSmallInteger() ? a.m_numerator <=> b.m_numerator : a.compare(b);
  }

  /// Numerator and denominator where both fit a machine word.
  struct Words {
    std::int64_t numerator;
    std::int64_t denominator;
  };
  [[nodiscard]] std::optional<Words> words() const {
    return isSmall() ? std::optional<Words>({m_numerator, m_denominator}) : std::nullopt;
  }

private:
  __extension__ using TwoWords = __int128;

  [[nodiscard]] bool isSmall() const { return m_big == nullptr; }
  [[nodiscard]] bool isSmallInteger() const { return m_big == nullptr && m_denominator == 1; }
  /// An integer that a word does not hold, by its bits.
  [[nodiscard]] static Rational beyondWords(bool isNegative, std::uint64_t bits);
  [[nodiscard]] static Rational fromParts(TwoWords numerator, TwoWords denominator);

  [[nodiscard]] Rational plus(const Rational &other) const;
  [[nodiscard]] Rational times(const Rational &other) const;
  [[nodiscard]] Rational over(const Rational &divisor) const;
  [[nodiscard]] std::strong_ordering compare(const Rational &other) const;

  // A word never holds the least of its values, so that each can be negated. Where m_big is set, the words
  // are 0 and 1. It is never changed, so copies share it.
  std::int64_t m_numerator = 0;
  std::int64_t m_denominator = 1;
  std::shared_ptr<const Big> m_big;
};

[[nodiscard]] inline Rational abs(const Rational &value) { return value.sign() < 0 ? -value : value; }

/// As `toText`.
std::ostream &operator<<(std::ostream &out, const Rational &value);

/// The most digits that the readers below take: in a decimal before its exponent, in a numerator, in a
/// denominator.
inline constexpr std::size_t maxDigits = 200;
/// The largest magnitude of a decimal exponent that they take.
inline constexpr int maxExponent = 400;

/// The fraction that a text spells: a decimal or `p/q` (below), nothing for any other text.
/// (1) parseRational(toText(x)) = x, where numerator and denominator have at most `maxDigits` digits.
[[nodiscard]] std::optional<Rational> parseRational(std::string_view text);

/// The fraction that a decimal is, exactly: `-1.5`, `2e-3`. Without spaces; nothing for any other text or
/// beyond the limits above.
[[nodiscard]] std::optional<Rational> parseDecimal(std::string_view text);

/// `p` or `p/q` of integers, each an optional `-` and digits. Without spaces; nothing for any other text, a
/// zero denominator, or beyond the limits above.
[[nodiscard]] std::optional<Rational> parseFraction(std::string_view text);

/// Why a text is not read: it spells no number, or one beyond the limits above: of many digits, or far
/// from 1.
enum class NotRead { NoNumber, TooLong, TooLarge };

/// For a text that parseRational does not read.
[[nodiscard]] NotRead whyNotRead(std::string_view text);

/// 10 to a whole power.
/// (1) powerOfTen(a)·powerOfTen(b) = powerOfTen(a + b).
[[nodiscard]] Rational powerOfTen(int exponent);

/// `p` or `p/q` in lowest terms.
[[nodiscard]] std::string toText(const Rational &value);

/// The double nearest to the exact value, of two as near the even one; ±infinity beyond the range of doubles.
/// (1) toDouble(−x) = −toDouble(x).
/// (2) toDouble(x) ≤ toDouble(y) for x ≤ y.
/// (3) toDouble(exactly(x)) = x.
[[nodiscard]] double toDouble(const Rational &value);
/// So that an algorithm written for both scalars can say `toDouble` of either.
[[nodiscard]] inline double toDouble(double value) { return value; }

/// The exact value of a double. Requires a finite one.
[[nodiscard]] Rational exactly(double value);

/// The largest whole number that is not above the value.
[[nodiscard]] Rational floorOf(const Rational &value);

/// The multiple of `step` nearest to the value; halves go up. Requires step > 0.
/// (1) It is a whole number of steps and at most step/2 away.
/// (2) A multiple of the step stays as it is.
/// (3) round(x + k·step) = round(x) + k·step for whole k.
[[nodiscard]] Rational roundToMultiple(const Rational &value, const Rational &step);

/// The lowest multiple of `step` that is not below the value. Requires step > 0.
[[nodiscard]] Rational roundUpToMultiple(const Rational &value, const Rational &step);

/// The exact value of a double, rounded to the nearest multiple of `step`. Requires a finite one.
[[nodiscard]] Rational roundToMultiple(double value, const Rational &step);

} // namespace halfspace
