#include "geometry/rational.h"

#include <cmath>
#include <limits>

namespace halfspace {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Takes the digits at the front of `text` off it.
std::string_view takeDigits(std::string_view &text) {
  std::size_t count = 0;
  while (count < text.size() && isDigit(text[count]))
    ++count;
  const auto digits = text.substr(0, count);
  text.remove_prefix(count);
  return digits;
}

bool takeChar(std::string_view &text, char c) {
  if (text.empty() || text.front() != c)
    return false;
  text.remove_prefix(1);
  return true;
}

/// Decimal digits, leading zeros allowed (Boost would read `010` as octal).
Integer integerOf(std::string_view digits) {
  Integer value = 0;
  for (const char digit : digits)
    value = value * 10 + (digit - '0');
  return value;
}

Integer powerOfTen(int exponent) { return mp::pow(Integer(10), static_cast<unsigned>(exponent)); }

/// The signed exponent after `e`, or nothing when it is malformed or too large.
std::optional<int> takeExponent(std::string_view &text) {
  const bool negative = takeChar(text, '-');
  if (!negative)
    takeChar(text, '+');
  auto digits = takeDigits(text);
  if (digits.empty())
    return {};
  while (digits.size() > 1 && digits.front() == '0')
    digits.remove_prefix(1);
  if (digits.size() > 3)
    return {};
  const int magnitude = std::stoi(std::string(digits));
  if (magnitude > maxExponent)
    return {};
  return negative ? -magnitude : magnitude;
}

std::optional<Rational> parseFraction(std::string_view numerator, std::string_view text) {
  const bool negative = takeChar(text, '-');
  const auto denominator = takeDigits(text);
  if (denominator.empty() || !text.empty() || denominator.size() > maxDigits)
    return {};
  const Integer q = integerOf(denominator);
  if (q == 0)
    return {};
  const Rational value(integerOf(numerator), q);
  return negative ? Rational(-value) : value;
}

std::optional<Rational> parseUnsigned(std::string_view text) {
  const auto whole = takeDigits(text);
  if (!whole.empty() && whole.size() <= maxDigits && takeChar(text, '/'))
    return parseFraction(whole, text);

  std::string_view decimals;
  if (takeChar(text, '.')) {
    decimals = takeDigits(text);
    if (decimals.empty())
      return {};
  }
  if (whole.size() + decimals.size() > maxDigits || whole.empty())
    return {};
  int exponent = 0;
  if (takeChar(text, 'e') || takeChar(text, 'E')) {
    const auto given = takeExponent(text);
    if (!given)
      return {};
    exponent = *given;
  }
  if (!text.empty())
    return {};

  exponent -= static_cast<int>(decimals.size());
  const Integer digits = integerOf(std::string(whole).append(decimals));
  if (exponent >= 0)
    return Rational(digits * powerOfTen(exponent));
  return Rational(digits, powerOfTen(-exponent));
}

int bitLength(const Integer &positive) { return static_cast<int>(mp::msb(positive)) + 1; }

} // namespace

std::optional<Rational> parseRational(std::string_view text) {
  const bool negative = takeChar(text, '-');
  const auto value = parseUnsigned(text);
  if (!value)
    return {};
  return negative ? Rational(-*value) : *value;
}

std::string toText(const Rational &value) {
  const Integer q = mp::denominator(value);
  std::string text = Integer(mp::numerator(value)).str();
  if (q != 1)
    text += "/" + q.str();
  return text;
}

double nearestDouble(const Integer &p, const Integer &q, int exponent) {
  if (p == 0)
    return 0;
  const Integer magnitude = mp::abs(p);

  // Scale so that the quotient has 64 or 65 bits; a last odd bit stands for all that the division cut off, so
  // that the one rounding below rounds the true value.
  const int shift = 65 - (bitLength(magnitude) - bitLength(q));
  const Integer dividend = shift > 0 ? Integer(magnitude << shift) : magnitude;
  const Integer divisor = shift < 0 ? Integer(q << -shift) : q;
  Integer quotient;
  Integer remainder;
  mp::divide_qr(dividend, divisor, quotient, remainder);
  if (remainder != 0)
    quotient |= 1;

  // Keep the bits that a double of this size has: 53, fewer when it is subnormal.
  const int top = bitLength(quotient) - shift + exponent;
  const int kept =
      std::min(std::numeric_limits<double>::digits,
               top - (std::numeric_limits<double>::min_exponent - std::numeric_limits<double>::digits));
  if (kept < 0)
    return p < 0 ? -0.0 : 0.0;
  const int dropped = bitLength(quotient) - kept;
  Integer mantissa = quotient >> dropped;
  const Integer rest = quotient - (mantissa << dropped);
  const Integer half = Integer(1) << (dropped - 1);
  if (rest > half || (rest == half && mp::bit_test(mantissa, 0)))
    ++mantissa;
  const double value = std::ldexp(mantissa.convert_to<double>(), dropped - shift + exponent);
  return p < 0 ? -value : value;
}

double toDouble(const Rational &value) { return nearestDouble(mp::numerator(value), mp::denominator(value)); }

Rational roundToMultiple(const Rational &value, const Rational &step) {
  const Rational count = value / step + Rational(1, 2);
  const Integer p = mp::numerator(count);
  const Integer q = mp::denominator(count);
  Integer floor = p / q;
  if (p < 0 && floor * q != p)
    --floor;
  return Rational(floor) * step;
}

Rational roundToMultiple(double value, const Rational &step) {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  const Integer digits(static_cast<long long>(std::ldexp(mantissa, 53)));
  exponent -= 53;
  const Rational exact = exponent >= 0 ? Rational(Integer(digits << exponent))
                                       : Rational(digits, Integer(Integer(1) << -exponent));
  return roundToMultiple(exact, step);
}

} // namespace halfspace
