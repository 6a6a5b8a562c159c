// Numbers as people type them.
#pragma once

#include "geometry/rational.h"

#include <optional>
#include <string>
#include <string_view>

namespace halfspace {

/// With a plain minus and a plain slash, where keyboards and text programs put a dash, −, ÷ or ⁄.
[[nodiscard]] std::string plainSigns(std::string_view typed);

/// A whole number with a fraction behind it: 1 1/2 is 3/2, −3 1/3 is −10/3. Nothing for any other text, and
/// where the fraction has a zero below.
[[nodiscard]] std::optional<Rational> parseMixed(std::string_view typed);

/// The number in the spelling that files have: without spaces and a plus sign, with a plain minus, a digit
/// before the decimal point, and a mixed number as one fraction. What is no number stays none.
[[nodiscard]] std::string plainSpelling(std::string_view typed, char decimalMark = '.');

} // namespace halfspace
