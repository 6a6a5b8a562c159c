// Exact numbers: integers and fractions of any size.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/rational_adaptor.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace halfspace {

namespace mp = boost::multiprecision;

/// An integer of any size. Expression templates are off: GLM and `auto` need plain values.
using Integer = mp::number<mp::cpp_int_backend<>, mp::et_off>;

/// A fraction in lowest terms with a positive denominator.
using Rational = mp::number<mp::rational_adaptor<mp::cpp_int_backend<>>, mp::et_off>;

/// The most digits that `parseRational` takes: in a decimal before its exponent, in a numerator, in a
/// denominator.
inline constexpr std::size_t maxDigits = 200;
/// The largest magnitude of a decimal exponent that `parseRational` takes.
inline constexpr int maxExponent = 400;

/// The fraction that a text spells: a decimal (`-1.5`, `2e-3`: taken as exactly that decimal) or `p/q`,
/// without spaces. Nothing for any other text, a zero denominator, or a number beyond the limits above.
[[nodiscard]] std::optional<Rational> parseRational(std::string_view text);

/// `p` or `p/q` in lowest terms.
[[nodiscard]] std::string toText(const Rational &value);

/// The double nearest to the exact value; ±infinity beyond the range of doubles.
[[nodiscard]] double toDouble(const Rational &value);
/// So that an algorithm written for both scalars can say `toDouble` of either.
[[nodiscard]] inline double toDouble(double value) { return value; }

/// The double nearest to p/q (q > 0) scaled by 2^exponent; ±infinity beyond the range of doubles.
[[nodiscard]] double nearestDouble(const Integer &p, const Integer &q, int exponent = 0);

/// The multiple of `step` (> 0) nearest to the value; halves go up.
[[nodiscard]] Rational roundToMultiple(const Rational &value, const Rational &step);

/// The exact value of a finite double, rounded to the nearest multiple of `step`.
[[nodiscard]] Rational roundToMultiple(double value, const Rational &step);

} // namespace halfspace
