#include "lessons/term/written.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace halfspace {
namespace {

/// Denominators of more than this are written as decimals where the decimal ends: 6.37, not 637/100.
constexpr std::int64_t largestFractionDenominator = 12;

Term digits(std::string text) {
  const auto node = std::make_shared<TermNode>();
  node->kind = TermKind::Digits;
  node->digits = std::move(text);
  return Term(node);
}

Term signedTerm(bool negative, Term term) { return negative ? -std::move(term) : std::move(term); }

/// The digits after the point that the exact decimal of p/q needs, or −1 when it never ends.
int decimalPlaces(std::int64_t q) {
  int twos = 0;
  int fives = 0;
  for (; q % 2 == 0; q /= 2)
    ++twos;
  for (; q % 5 == 0; q /= 5)
    ++fives;
  return q == 1 ? std::max(twos, fives) : -1;
}

std::string decimalText(const Rational &magnitude, int places) {
  std::string text = toText(Rational(magnitude * powerOfTen(places)));
  const auto fraction = static_cast<std::size_t>(places);
  if (text.size() <= fraction)
    text.insert(0, fraction + 1 - text.size(), '0');
  return text.insert(text.size() - fraction, ".");
}

/// 6.02214·10²³
Term scientific(const std::string &mantissa, int exponent) {
  const auto power = std::make_shared<TermNode>();
  power->kind = TermKind::Power;
  power->parts = {digits("10"), signedTerm(exponent < 0, digits(std::to_string(std::abs(exponent))))};
  return digits(mantissa) * Term(power);
}

/// p/q of positive integers, `root` behind p.
Term fraction(const Rational &magnitude, const std::optional<Term> &root) {
  const std::string text = toText(magnitude); // p or p/q
  const auto slash = text.find('/');
  const std::string p = text.substr(0, slash);
  const Term top = !root ? digits(p) : p == "1" ? *root : digits(p) * *root;
  return slash == std::string::npos ? top : top / digits(text.substr(slash + 1));
}

/// The characters of an exact form without the sign in front.
std::size_t lengthOf(std::string_view exactForm) {
  return exactForm.size() - (exactForm.starts_with('-') ? 1 : 0);
}

/// How a number may be written.
enum class Look : std::uint8_t {
  Exact,   ///< whole, a fraction, a root
  Decimal, ///< one that ends
  Rounded
};

/// The decimal of a fraction that is not whole, without its sign; empty where it does not end soon.
std::string shortDecimalOf(const Rational &value) {
  const auto words = value.words();
  const int places = words ? decimalPlaces(words->denominator) : -1;
  const std::string decimal = places > 0 ? decimalText(abs(value), places) : "";
  return decimal.size() <= longestExactForm ? decimal : "";
}

Look ownLook(const Rational &value) {
  static_assert(longestExactForm <= std::numeric_limits<std::int64_t>::digits10);
  const auto words = value.words();
  if (!words || lengthOf(toText(value)) > longestExactForm)
    return Look::Rounded;
  const bool isSmall = words->denominator <= largestFractionDenominator;
  return isSmall || shortDecimalOf(value).empty() ? Look::Exact : Look::Decimal;
}

Look ownLook(const Surd &value) {
  if (value.isRational())
    return ownLook(value.rationalPart());
  const auto text = toText(value);
  const bool isLong = !text || lengthOf(*text) > longestExactForm + std::string_view("*sqrt()").size();
  return isLong ? Look::Rounded : Look::Exact;
}

Look ownLook(const Real &number) { return number.exact() ? ownLook(*number.exact()) : Look::Rounded; }

Term exactForm(const Surd &value) {
  const Rational &part = value.rationalPart();
  Term rational = signedTerm(part.sign() < 0, fraction(abs(part), {}));
  if (value.isRational())
    return rational;
  const Term root =
      signedTerm(value.rootFactor() < 0,
                 fraction(abs(value.rootFactor()), halfspace::root(digits(toText(value.radicand())))));
  return part == 0 ? root : rational + root;
}

Term decimalForm(const Rational &value) {
  const std::string decimal = shortDecimalOf(value);
  return decimal.empty() ? exactForm(value) : signedTerm(value.sign() < 0, digits(decimal));
}

/// Requires a look that the number can have.
WrittenNumber written(const Real &number, Look look) {
  const Surd *value = number.exact();
  if (!value)
    return {rounded(toDouble(number)), false};
  if (look == Look::Rounded)
    return decimalOf(*value);
  const bool isFraction = value->isRational() && look == Look::Decimal;
  return {isFraction ? decimalForm(value->rationalPart()) : exactForm(*value), true};
}

/// Whether a number can be written as a decimal that ends.
bool isDecimal(const Real &number) {
  const Surd *value = number.exact();
  return value && value->isRational() &&
         (value->rationalPart().denominator() == 1 || !shortDecimalOf(value->rationalPart()).empty());
}

/// How many digits stand before the decimal point; 0 where they are too many to be written.
int wholeDigits(double magnitude) {
  int digits = 0;
  for (double next = 1; next <= magnitude; next *= 10)
    if (++digits > shownDigits)
      return 0;
  return digits;
}

/// 31.4159, 6.02214e23; for a finite number ≥ 0.
std::string shortDecimal(double magnitude, int most) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), magnitude,
                                 std::chars_format::general, std::max(most, wholeDigits(magnitude)))
                       .ptr;
  return {buffer.data(), end};
}

} // namespace

Term rounded(double value, int most) {
  const bool negative = value < 0;
  if (!std::isfinite(value))
    return signedTerm(negative, digits("∞"));
  const std::string text = shortDecimal(std::abs(value), most);
  const auto e = text.find('e');
  return signedTerm(negative, e == std::string::npos
                                  ? digits(text)
                                  : scientific(text.substr(0, e), std::stoi(text.substr(e + 1))));
}

WrittenNumber decimalOf(const Surd &number, int most) {
  const double value = toDouble(number);
  const auto same = std::isfinite(value) ? parseDecimal(shortDecimal(std::abs(value), most)) : std::nullopt;
  return {rounded(value, most), same && number.isRational() && abs(number.rationalPart()) == *same};
}

WrittenNumber written(const Real &number) { return written(number, ownLook(number)); }

std::vector<WrittenNumber> writtenAlike(const std::vector<Real> &numbers) {
  Look look = Look::Exact;
  for (const Real &number : numbers)
    look = std::max(look, ownLook(number));
  if (look == Look::Decimal && !std::all_of(numbers.begin(), numbers.end(), isDecimal))
    look = Look::Exact;
  std::vector<WrittenNumber> all;
  all.reserve(numbers.size());
  for (const Real &number : numbers)
    all.push_back(written(number, look));
  return all;
}

bool showsRounded(const Term &term) {
  return term->isRounded || std::any_of(term->parts.begin(), term->parts.end(), showsRounded);
}

} // namespace halfspace
