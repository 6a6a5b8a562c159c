#include "lessons/reading/typed_number.h"

#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>

namespace halfspace {
namespace {

/// With plain signs, and without a plus in front.
std::string withoutPlus(std::string_view typed) {
  std::string text = plainSigns(trimmed(typed));
  return text.starts_with('+') ? text.substr(1) : text;
}

bool areDigits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

std::string withoutSpaces(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
  return text;
}

bool hasTooManyDigits(const Rational &whole) {
  static const Rational shortestTooLong = powerOfTen(coordinateDigits);
  return abs(whole) >= shortestTooLong;
}

std::string sentenceForTooLarge() {
  return words("This number is too large: coordinates go from −{limit} to {limit}.",
               {{"limit", toText(coordinateLimit)}});
}

std::string sentenceForTooLong() {
  return words("This number is too long: as a fraction it may have {digits} digits above and below the line.",
               {{"digits", std::to_string(coordinateDigits)}});
}

} // namespace

std::string plainSigns(std::string_view typed) {
  std::string text(typed);
  for (const char *minus : {"−", "–"})
    text = replacedAll(std::move(text), minus, "-");
  for (const char *slash : {"÷", "⁄"})
    text = replacedAll(std::move(text), slash, "/");
  return text;
}

std::optional<Rational> parseMixed(std::string_view typed) {
  const std::string text = withoutPlus(typed);
  const bool negative = text.starts_with('-');
  const std::string magnitude(trimmed(std::string_view(text).substr(negative ? 1 : 0)));
  const auto space = magnitude.find(' ');
  if (space == std::string::npos || !areDigits(magnitude.substr(0, space)))
    return {};
  const std::string fraction = withoutSpaces(magnitude.substr(space));
  const bool isFraction = fraction.find('/') != std::string::npos && !fraction.starts_with('-');
  const auto whole = parseRational(magnitude.substr(0, space));
  const auto part = isFraction ? parseFraction(fraction) : std::nullopt;
  if (!whole || !part)
    return {};
  const Rational value = *whole + *part;
  return negative ? -value : value;
}

std::string plainSpelling(std::string_view typed, char decimalMark) {
  if (const auto mixed = parseMixed(typed))
    return toText(*mixed);
  std::string text = withoutPlus(typed);
  if (decimalMark != '.')
    std::replace(text.begin(), text.end(), decimalMark, '.');
  text = withoutSpaces(std::move(text));
  if (text.starts_with('.') || text.starts_with("-."))
    text.insert(text.find('.'), 1, '0');
  return text;
}

std::optional<std::string> refuseCoordinate(const Rational &value) {
  if (abs(value) > coordinateLimit)
    return sentenceForTooLarge();
  if (hasTooManyDigits(value.numerator()) || hasTooManyDigits(value.denominator()))
    return sentenceForTooLong();
  return {};
}

std::string sentenceForNotRead(std::string_view text, char decimalMark) {
  switch (whyNotRead(text)) {
  case NotRead::TooLarge:
    return sentenceForTooLarge();
  case NotRead::TooLong:
    return sentenceForTooLong();
  case NotRead::NoNumber:
    break;
  }
  return words("“{text}” is not a number: write it as 3, {decimal} or -10/3.",
               {{"text", shortened(text)}, {"decimal", std::string("-1") + decimalMark + "5"}});
}

Result<Rational> readCoordinate(std::string_view text) {
  const auto value = parseRational(text);
  if (!value)
    return Problem{sentenceForNotRead(text), "", 0, ""};
  if (const auto refused = refuseCoordinate(*value))
    return Problem{*refused, "", 0, ""};
  return *value;
}

} // namespace halfspace
