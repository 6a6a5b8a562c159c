// Numbers as people type them, and which of them may be coordinates.
#pragma once

#include "geometry/rational.h"
#include "lessons/result.h"

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

/// Coordinates are bounded so that every picture and every exact number stays within reason.
inline const Rational coordinateLimit = 1000000000;
/// The most digits of a coordinate's numerator or denominator.
inline constexpr std::size_t coordinateDigits = 40;

/// Whether a typed number may become a coordinate; if not, the sentence that says why.
[[nodiscard]] std::optional<std::string> refuseCoordinate(const Rational &value);

/// A coordinate as it is typed or written: a number that parseRational reads and refuseCoordinate takes.
[[nodiscard]] Result<Rational> readCoordinate(std::string_view text);

/// Why a text that parseRational does not read is no coordinate: it is not a number, as one is written with
/// this mark, or one beyond the limits.
[[nodiscard]] std::string sentenceForNotRead(std::string_view text, char decimalMark = '.');

} // namespace halfspace
