// Fractions as text.
#include "geometry/integer.h"

#include <array>
#include <charconv>
#include <limits>
#include <ostream>

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

std::ostream &operator<<(std::ostream &out, const Rational &value) { return out << toText(value); }

} // namespace halfspace
