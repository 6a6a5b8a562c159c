#include "widgets/scene/number_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

namespace halfspace {
namespace {

constexpr std::size_t longestText =
    std::numeric_limits<double>::max_exponent10 + 1 + std::string_view("-.000").size();

} // namespace

std::string numberText(double number) {
  const double rounded = std::round(number * 1000) / 1000;
  std::array<char, longestText> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), rounded == 0 ? 0.0 : rounded,
                                 std::chars_format::fixed, 3)
                       .ptr;
  std::string digits(text.data(), end);
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.')
    digits.pop_back();
  return digits;
}

} // namespace halfspace
