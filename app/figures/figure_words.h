// The words and limits of what is chosen of figures, the same on the command line and in kept settings.
#pragma once

#include "app/figures/figure_choices.h"

#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace halfspace {

/// Smaller and larger pages and type are for nobody, in points.
inline constexpr double leastWidth = pointsPerCentimetre;
inline constexpr double mostWidth = 100 * pointsPerCentimetre;
inline constexpr double leastType = 3;
inline constexpr double mostType = 72;
/// Labels of larger type, in parts of the width, find no place beside one another.
inline constexpr double mostTypePerWidth = 0.1;
/// As coarse as a screen of long ago, and as fine as a typesetter.
inline constexpr double leastPixelsPerInch = 10;
inline constexpr double mostPixelsPerInch = 2400;
/// Of one that is measured in pixels.
inline constexpr int leastPixelsAcross = 16;

/// How what is hidden may be drawn, by its word.
inline constexpr std::array hiddenWords{std::pair("dashed", HiddenLines::Dashed),
                                        std::pair("paler", HiddenLines::Paler),
                                        std::pair("left-out", HiddenLines::LeftOut)};
/// How formulas may be written.
inline constexpr std::array textWords{std::pair("shapes", TextAs::Shapes),
                                      std::pair("letters", TextAs::Letters)};

/// What a word stands for; nothing where it is none of them.
template <class Meaning, std::size_t count>
[[nodiscard]] std::optional<Meaning>
meant(const std::array<std::pair<const char *, Meaning>, count> &wordList, std::string_view word) {
  for (const auto &[name, meaning] : wordList)
    if (word == name)
      return meaning;
  return {};
}

/// The word for something; each has one.
template <class Meaning, std::size_t count>
[[nodiscard]] const char *wordFor(const std::array<std::pair<const char *, Meaning>, count> &wordList,
                                  Meaning meaning) {
  for (const auto &[name, other] : wordList)
    if (other == meaning)
      return name;
  return wordList.front().first;
}

} // namespace halfspace
