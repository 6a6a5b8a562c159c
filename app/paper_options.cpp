#include "app/paper_options.h"

#include "lessons/words.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

namespace halfspace {
namespace {

/// A positive length in points: 8cm, 80mm or 226pt.
std::optional<double> parseLength(std::string_view text) {
  double value = 0;
  const auto [unit, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || !(value > 0))
    return {};
  const std::string_view rest = text.substr(static_cast<std::size_t>(unit - text.data()));
  for (const auto &[name, points] :
       {std::pair("cm", pointsPerCentimetre), {"mm", pointsPerCentimetre / 10}, {"pt", 1.0}})
    if (rest == name)
      return value * points;
  return {};
}

/// Smaller and larger pages and type are for nobody, in points.
constexpr double leastWidth = pointsPerCentimetre;
constexpr double mostWidth = 100 * pointsPerCentimetre;
constexpr double leastType = 3;
constexpr double mostType = 72;
/// Labels of larger type, in parts of the width, find no place beside one another.
constexpr double mostTypePerWidth = 0.1;

/// How what is hidden may be drawn, by its word.
constexpr std::array hiddenWords{std::pair("dashed", HiddenLines::Dashed),
                                 std::pair("paler", HiddenLines::Paler),
                                 std::pair("left-out", HiddenLines::LeftOut)};

Problem refused(const std::string &sentence) { return {sentence, "", 0, ""}; }

} // namespace

void addPaperOptions(CLI::App &render, PaperOptions &options) {
  render.add_option("--width", options.width, words("How wide a figure of vectors is, in cm, mm or pt"))
      ->type_name("LENGTH")
      ->capture_default_str();
  render.add_option("--text", options.typeSize, words("The size of its type"))
      ->type_name("LENGTH")
      ->capture_default_str();
  render
      .add_option("--hidden", options.hidden,
                  words("How its lines are drawn where a face stands before them"))
      ->type_name("dashed|paler|left-out")
      ->capture_default_str();
}

Result<PaperCommand> paperOf(const PaperOptions &options) {
  const auto width = parseLength(options.width);
  if (!width || *width < leastWidth || *width > mostWidth)
    return refused(words("--width takes a length from 1cm to 100cm, as 8cm, 80mm or 227pt, not “{width}”.",
                         {{"width", options.width}}));
  const auto typeSize = parseLength(options.typeSize);
  if (!typeSize || *typeSize < leastType || *typeSize > mostType)
    return refused(
        words("--text takes a size of type from 3pt to 72pt, not “{size}”.", {{"size", options.typeSize}}));
  if (*typeSize > *width * mostTypePerWidth)
    return refused(words("Type of {size} is too large for a figure {width} wide: at most a tenth of that.",
                         {{"size", options.typeSize}, {"width", options.width}}));
  const auto hidden = std::find_if(hiddenWords.begin(), hiddenWords.end(),
                                   [&](const auto &word) { return options.hidden == word.first; });
  if (hidden == hiddenWords.end())
    return refused(
        words("--hidden takes dashed, paler or left-out, not “{hidden}”.", {{"hidden", options.hidden}}));
  return PaperCommand{*width, *typeSize, hidden->second};
}

} // namespace halfspace
