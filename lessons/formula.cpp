#include "lessons/formula.h"

#include "lessons/working.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace halfspace {
namespace {

/// Denominators of more than this are written as decimals where the decimal ends: 6.37, not 637/100.
constexpr std::int64_t largestFractionDenominator = 12;

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

std::string decimalText(const Rational &value, int places) {
  Rational scaled = abs(value);
  for (int place = 0; place < places; ++place)
    scaled *= 10;
  std::string digits = toText(scaled);
  const auto fraction = static_cast<std::size_t>(places);
  if (digits.size() <= fraction)
    digits.insert(0, fraction + 1 - digits.size(), '0');
  digits.insert(digits.size() - fraction, ".");
  return (value < 0 ? "-" : "") + digits;
}

ShownNumber rounded(double value) { return {roundedText(value), false}; }

/// p/q with the sign in front of the fraction; `root` is written behind the numerator.
std::string fractionLatex(const Rational &value, const std::string &root) {
  const std::string magnitude = toText(abs(value));
  const auto slash = magnitude.find('/');
  const std::string p = magnitude.substr(0, slash);
  std::string top = p == "1" && !root.empty() ? root : p + root;
  if (slash != std::string::npos)
    top = "\\frac{" + top + "}{" + magnitude.substr(slash + 1) + "}";
  return (value < 0 ? "-" : "") + top;
}

bool startsWithMinus(const std::string &latex) { return !latex.empty() && latex.front() == '-'; }

/// In a row of coordinates tall fractions would tear the line apart.
std::string small(std::string latex) {
  for (std::size_t at = latex.find("\\frac"); at != std::string::npos; at = latex.find("\\frac", at + 6))
    latex.insert(at + 1, "t");
  return latex;
}

} // namespace

std::string roundedText(double value) {
  if (!std::isfinite(value))
    return "\\infty";
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::general, shownDigits)
                       .ptr;
  std::string text(buffer.data(), end);
  const auto e = text.find('e');
  if (e == std::string::npos)
    return text;
  const int exponent = std::stoi(text.substr(e + 1));
  return text.substr(0, e) + "\\cdot 10^{" + std::to_string(exponent) + "}";
}

ShownNumber show(const Rational &value) {
  static_assert(longestExactForm <= std::numeric_limits<std::int64_t>::digits10);
  const auto words = value.words();
  if (!words || toText(value).size() > longestExactForm)
    return rounded(toDouble(value));
  const std::int64_t q = words->denominator;
  const int places = q > largestFractionDenominator ? decimalPlaces(q) : -1;
  return {places > 0 ? decimalText(value, places) : fractionLatex(value, ""), true};
}

ShownNumber show(const Surd &value) {
  if (value.isRational())
    return show(value.rationalPart());
  const auto text = toText(value);
  if (!text || text->size() > longestExactForm + std::string_view("*sqrt()").size())
    return rounded(toDouble(value));
  const std::string root = fractionLatex(value.rootFactor(), "\\sqrt{" + value.radicand().str() + "}");
  if (value.rationalPart() == 0)
    return {root, true};
  return {fractionLatex(value.rationalPart(), "") + (startsWithMinus(root) ? "" : "+") + root, true};
}

std::string Formula::operator()(const Rational &value) { return (*this)(Surd(value)); }

std::string Formula::operator()(const Surd &value) {
  const ShownNumber shown = show(value);
  m_exact = m_exact && shown.exact;
  return shown.latex;
}

std::string Formula::operator()(const ExactVec3 &value) { return list(listOf(value)); }

std::string Formula::list(const std::vector<Surd> &values) {
  std::string entries;
  for (const Surd &value : values)
    entries += (entries.empty() ? "" : ",\\,") + small((*this)(value));
  return "\\left(" + entries + "\\right)";
}

std::string Formula::factor(const Rational &value) {
  const std::string latex = (*this)(value);
  return startsWithMinus(latex) ? "(" + latex + ")" : latex;
}

std::string Formula::squared(const Rational &value) {
  const std::string latex = (*this)(value);
  const bool isPlain = latex.find_first_not_of("0123456789.") == std::string::npos;
  return (isPlain ? latex : "\\left(" + latex + "\\right)") + "^2";
}

std::string Formula::addend(const Rational &value) {
  if (value == 0)
    return "";
  const std::string latex = (*this)(value);
  return startsWithMinus(latex) ? " - " + latex.substr(1) : " + " + latex;
}

std::string Formula::products(const ExactVec3 &a, const ExactVec3 &b) {
  const auto product = [this](const Rational &x, const Rational &y) {
    return factor(x) + "\\cdot " + factor(y);
  };
  return product(a.x, b.x) + " + " + product(a.y, b.y) + " + " + product(a.z, b.z);
}

std::string Formula::quotient(const Surd &p, const Surd &q) {
  const std::string top = small((*this)(p));
  return "\\frac{" + top + "}{" + small((*this)(q)) + "}";
}

std::string Formula::linear(const std::vector<Surd> &coefficients,
                            const std::vector<std::string> &variables) {
  std::string sum;
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    if (coefficients[i].sign() == 0)
      continue;
    std::string term = small((*this)(coefficients[i]));
    const bool negative = startsWithMinus(term);
    if (negative)
      term.erase(0, 1);
    if (i < variables.size())
      term = (term == "1" ? "" : term) + variables[i];
    if (sum.empty())
      sum = (negative ? "-" : "") + term;
    else
      sum += (negative ? " - " : " + ") + term;
  }
  return sum.empty() ? "0" : sum;
}

std::string Formula::equals(const std::string &body) const { return (m_exact ? "= " : "\\approx ") + body; }

std::string marked(std::string_view id, std::string_view latex) {
  return "\\mark{" + std::string(id) + "}{" + std::string(latex) + "}";
}

std::string equation(std::string_view name, const Surd &value) {
  const ShownNumber shown = show(value);
  return std::string(name) + (shown.exact ? " = " : " ≈ ") + plainText(shown.latex);
}

std::string equation(std::string_view name, const ExactVec3 &value) {
  Formula f;
  const std::string coordinates = f(value);
  return std::string(name) + " " + plainText(f.equals(coordinates));
}

std::vector<Surd> coefficientsOf(const Plane<Rational> &plane) {
  return {plane.normal.x, plane.normal.y, plane.normal.z, plane.offset};
}

std::vector<Surd> listOf(const ExactVec3 &value) { return {value.x, value.y, value.z}; }

} // namespace halfspace
