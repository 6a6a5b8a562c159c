#include "geometry/integer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <charconv>
#include <cmath>
#include <ostream>

namespace halfspace {

// --- The number itself

namespace {

__extension__ using TwoWords = __int128;

bool fitsWord(TwoWords value) {
  constexpr TwoWords largest = std::numeric_limits<std::int64_t>::max();
  return -largest <= value && value <= largest;
}

bool fitsWord(const Integer &value) { return mp::abs(value) <= std::numeric_limits<std::int64_t>::max(); }

/// Of two words; the result is positive where one of them is not 0. Stein's algorithm without branches that
/// depend on the numbers: std::gcd has one at every step, and takes three times as long.
std::int64_t greatestCommonDivisor(std::int64_t first, std::int64_t second) {
  auto a = static_cast<std::uint64_t>(std::abs(first));
  auto b = static_cast<std::uint64_t>(std::abs(second));
  if (a == 1 || b == 1)
    return 1;
  if (a == 0 || b == 0)
    return static_cast<std::int64_t>(a | b);
  const int commonTwos = std::countr_zero(a | b);
  a >>= std::countr_zero(a);
  while (b != 0) {
    b >>= std::countr_zero(b);
    const std::uint64_t difference = a > b ? a - b : b - a;
    a = std::min(a, b);
    b = difference;
  }
  return static_cast<std::int64_t>(a << commonTwos);
}

/// value mod divisor; the machine divides single words many times faster than double ones.
std::int64_t remainder(TwoWords value, std::int64_t divisor) {
  return fitsWord(value) ? static_cast<std::int64_t>(value) % divisor
                         : static_cast<std::int64_t>(value % divisor);
}

} // namespace

Rational::Rational(Big value) {
  const Integer p = mp::numerator(value.value);
  const Integer q = mp::denominator(value.value);
  if (fitsWord(p) && fitsWord(q))
    *this = fromParts(static_cast<std::int64_t>(p), static_cast<std::int64_t>(q));
  else
    m_big = std::make_shared<const Big>(std::move(value));
}

Rational Rational::beyondWords(bool isNegative, std::uint64_t bits) {
  const Integer magnitude(isNegative ? -bits : bits);
  return rationalOf(isNegative ? Integer(-magnitude) : magnitude);
}

Rational Rational::fromParts(TwoWords numerator, TwoWords denominator) {
  Rational result;
  result.m_numerator = static_cast<std::int64_t>(numerator);
  result.m_denominator = static_cast<std::int64_t>(denominator);
  return result;
}

Rational::Big Rational::big() const {
  return m_big ? *m_big : Big{{Integer(m_numerator), Integer(m_denominator)}};
}

Rational Rational::numerator() const {
  return m_big ? rationalOf(mp::numerator(m_big->value)) : fromParts(m_numerator, 1);
}

Rational Rational::denominator() const {
  return m_big ? rationalOf(mp::denominator(m_big->value)) : fromParts(m_denominator, 1);
}

bool Rational::isInteger() const { return m_big ? mp::denominator(m_big->value) == 1 : m_denominator == 1; }

int Rational::sign() const {
  if (m_big)
    return m_big->value.sign();
  return m_numerator < 0 ? -1 : m_numerator > 0 ? 1 : 0;
}

Rational Rational::operator-() const {
  return m_big ? Rational(Big{-m_big->value}) : fromParts(-m_numerator, m_denominator);
}

// The greatest common divisors are taken before the products, of single words (Knuth, The Art of Computer
// Programming 2, 4.5.1): then no result needs more than two words, and all are in lowest terms.

Rational Rational::plus(const Rational &other) const {
  if (isSmall() && other.isSmall()) {
    const std::int64_t common = greatestCommonDivisor(m_denominator, other.m_denominator);
    const std::int64_t rest = m_denominator / common;
    const TwoWords sum = static_cast<TwoWords>(m_numerator) * (other.m_denominator / common) +
                         static_cast<TwoWords>(other.m_numerator) * rest;
    const std::int64_t divisor = common == 1 ? 1 : greatestCommonDivisor(remainder(sum, common), common);
    const TwoWords numerator = divisor == 1 ? sum : sum / divisor;
    const TwoWords denominator = static_cast<TwoWords>(rest) * (other.m_denominator / divisor);
    if (fitsWord(numerator) && fitsWord(denominator))
      return fromParts(numerator, denominator);
  }
  return Rational(Big{big().value + other.big().value});
}

Rational Rational::times(const Rational &other) const {
  if (isSmall() && other.isSmall()) {
    const std::int64_t left = greatestCommonDivisor(m_numerator, other.m_denominator);
    const std::int64_t right = greatestCommonDivisor(other.m_numerator, m_denominator);
    const TwoWords numerator = static_cast<TwoWords>(m_numerator / left) * (other.m_numerator / right);
    const TwoWords denominator = static_cast<TwoWords>(m_denominator / right) * (other.m_denominator / left);
    if (fitsWord(numerator) && fitsWord(denominator))
      return fromParts(numerator, denominator);
  }
  return Rational(Big{big().value * other.big().value});
}

Rational Rational::over(const Rational &divisor) const {
  assert(divisor.sign() != 0);
  if (!divisor.isSmall())
    return Rational(Big{big().value / divisor.big().value});
  const bool negative = divisor.m_numerator < 0;
  return times(negative ? fromParts(-divisor.m_denominator, -divisor.m_numerator)
                        : fromParts(divisor.m_denominator, divisor.m_numerator));
}

std::strong_ordering Rational::compare(const Rational &other) const {
  if (isSmall() && other.isSmall()) {
    const TwoWords left = static_cast<TwoWords>(m_numerator) * other.m_denominator;
    const TwoWords right = static_cast<TwoWords>(other.m_numerator) * m_denominator;
    return left <=> right;
  }
  return big().value.compare(other.big().value) <=> 0;
}

Integer numeratorOf(const Rational &value) {
  const auto words = value.words();
  return words ? Integer(words->numerator) : Integer(mp::numerator(value.big().value));
}

Integer denominatorOf(const Rational &value) {
  const auto words = value.words();
  return words ? Integer(words->denominator) : Integer(mp::denominator(value.big().value));
}

Integer integerOf(const Rational &whole) {
  assert(whole.isInteger());
  return numeratorOf(whole);
}

Rational rationalOf(const Integer &value) {
  return fitsWord(value) ? Rational(static_cast<std::int64_t>(value)) : Rational(Rational::Big{value});
}

std::ostream &operator<<(std::ostream &out, const Rational &value) { return out << toText(value); }

// --- Reading and writing

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

/// As many digits as a word holds for sure.
constexpr std::size_t wordDigits = std::numeric_limits<std::int64_t>::digits10;

/// Decimal digits, leading zeros allowed (Boost would read `010` as octal).
Rational readDigits(std::string_view digits) {
  Rational value = 0;
  while (!digits.empty()) {
    const std::string_view part = digits.substr(0, wordDigits);
    digits.remove_prefix(part.size());
    std::int64_t word = 0;
    std::int64_t weight = 1;
    for (const char digit : part) {
      word = word * 10 + (digit - '0');
      weight *= 10;
    }
    value = value * weight + word;
  }
  return value;
}

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

std::optional<Rational> takeInteger(std::string_view &text) {
  const bool negative = takeChar(text, '-');
  const auto digits = takeDigits(text);
  if (digits.empty() || digits.size() > maxDigits)
    return {};
  const Rational value = readDigits(digits);
  return negative ? -value : value;
}

std::string wordText(std::int64_t value) {
  std::array<char, wordDigits + 2> text; // a sign, and one digit more than every word has
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

int bitLength(const Integer &positive) { return static_cast<int>(mp::msb(positive)) + 1; }

} // namespace

std::optional<Rational> parseRational(std::string_view text) {
  return text.find('/') == std::string_view::npos ? parseDecimal(text) : parseFraction(text);
}

std::optional<Rational> parseFraction(std::string_view text) {
  auto numerator = takeInteger(text);
  if (!numerator || text.empty())
    return numerator;
  if (!takeChar(text, '/'))
    return {};
  const auto denominator = takeInteger(text);
  if (!denominator || *denominator == 0 || !text.empty())
    return {};
  return *numerator / *denominator;
}

std::optional<Rational> parseDecimal(std::string_view text) {
  const bool negative = takeChar(text, '-');
  const auto whole = takeDigits(text);
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
  const Rational digits =
      readDigits(whole) * powerOfTen(static_cast<int>(decimals.size())) + readDigits(decimals);
  const Rational value = exponent >= 0 ? digits * powerOfTen(exponent) : digits / powerOfTen(-exponent);
  return negative ? -value : value;
}

Rational powerOfTen(int exponent) {
  static const auto words = [] {
    std::array<std::int64_t, wordDigits + 1> powers{1};
    for (std::size_t i = 1; i < powers.size(); ++i)
      powers[i] = powers[i - 1] * 10;
    return powers;
  }();
  const auto power = static_cast<std::size_t>(std::abs(exponent));
  const Rational value = power < words.size()
                             ? Rational(words[power])
                             : rationalOf(mp::pow(Integer(10), static_cast<unsigned>(power)));
  return exponent < 0 ? 1 / value : value;
}

NotRead whyNotRead(std::string_view text) {
  takeChar(text, '-');
  const bool hasWhole = !takeDigits(text).empty();
  bool isNumber = hasWhole;
  bool grows = false;
  if (takeChar(text, '/')) {
    takeChar(text, '-');
    isNumber = hasWhole && takeDigits(text).find_first_not_of('0') != std::string_view::npos;
  } else {
    if (takeChar(text, '.'))
      isNumber = !takeDigits(text).empty() && isNumber;
    if (takeChar(text, 'e') || takeChar(text, 'E')) {
      grows = !takeChar(text, '-');
      if (grows)
        takeChar(text, '+');
      isNumber = !takeDigits(text).empty() && isNumber;
    }
  }
  if (!isNumber || !text.empty())
    return NotRead::NoNumber;
  return grows ? NotRead::TooLarge : NotRead::TooLong;
}

std::string toText(const Rational &value) {
  if (const auto words = value.words()) {
    std::string text = wordText(words->numerator);
    if (words->denominator != 1)
      text += "/" + wordText(words->denominator);
    return text;
  }
  return value.big().value.str();
}

double nearestDouble(const Integer &p, const Integer &q, int exponent) {
  if (p == 0)
    return 0;
  const Integer magnitude = mp::abs(p);

  // Scale so that the quotient has 65 or 66 bits, more than a double's 53; a last odd bit stands for all that
  // the division cut off, so that the one rounding below rounds the true value.
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

double toDouble(const Rational &value) {
  // Where both parts are doubles the one division below rounds once.
  constexpr std::int64_t largestWhole = std::int64_t{1} << std::numeric_limits<double>::digits;
  const auto words = value.words();
  if (words && std::abs(words->numerator) <= largestWhole && words->denominator <= largestWhole)
    return static_cast<double>(words->numerator) / static_cast<double>(words->denominator);
  const BigFraction big = value.big().value;
  return nearestDouble(mp::numerator(big), mp::denominator(big));
}

Rational exactly(double value) {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  constexpr int digits = std::numeric_limits<double>::digits;
  const Integer whole(static_cast<std::int64_t>(std::ldexp(mantissa, digits)));
  exponent -= digits;
  const Rational power = rationalOf(Integer(1) << std::abs(exponent));
  return exponent >= 0 ? rationalOf(whole) * power : rationalOf(whole) / power;
}

Rational floorOf(const Rational &value) {
  const Integer p = numeratorOf(value);
  const Integer q = denominatorOf(value);
  Integer floor = p / q;
  if (p < 0 && floor * q != p)
    --floor;
  return rationalOf(floor);
}

Rational roundToMultiple(const Rational &value, const Rational &step) {
  return floorOf(value / step + Rational(1, 2)) * step;
}

Rational roundUpToMultiple(const Rational &value, const Rational &step) {
  return -floorOf(-value / step) * step;
}

Rational roundToMultiple(double value, const Rational &step) { return roundToMultiple(exactly(value), step); }

} // namespace halfspace
