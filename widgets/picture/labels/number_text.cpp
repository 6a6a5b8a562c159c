#include "widgets/picture/labels/number_text.h"

#include "lessons/term/latex.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

namespace halfspace {
namespace {

constexpr std::size_t longestText =
    std::numeric_limits<double>::max_exponent10 + 1 + std::string_view("-.000").size();

/// Numbers from here on are written with a power of ten, unless their own exponent is 0.
constexpr int longestDecimal = 5;
constexpr int shortestDecimal = -2;

/// As part of a number: a double that stands for a decimal is off by far less, one that does not by more.
constexpr double noise = 1e-9;

std::string decimalText(double number) {
  const double rounded = std::round(number * 1000) / 1000;
  const bool isExact = std::abs(rounded - number) <= noise * std::max(1.0, std::abs(number));
  std::array<char, longestText> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), rounded == 0 ? 0.0 : rounded,
                                 std::chars_format::fixed, 3)
                       .ptr;
  std::string digits(text.data(), end);
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.')
    digits.pop_back();
  return (isExact ? "" : "\\approx ") + latexDecimal(digits);
}

} // namespace

std::string numberText(double number, int exponent) {
  if (number == 0 || exponent == 0)
    return decimalText(number);
  const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(number))));
  const int whole = magnitude + exponent;
  if (whole >= shortestDecimal && whole < longestDecimal)
    return decimalText(number * std::pow(10.0, exponent));
  return decimalText(number / std::pow(10.0, magnitude)) + " \\cdot 10^{" + std::to_string(whole) + "}";
}

} // namespace halfspace
