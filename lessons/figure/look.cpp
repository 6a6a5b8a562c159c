#include "lessons/figure/look.h"

#include <algorithm>
#include <array>

namespace halfspace {
namespace {

constexpr std::array<std::string_view, hueCount> hues{"grey",  "blue",   "orange", "yellow",
                                                      "green", "purple", "pink",   "red"};
constexpr std::array<std::string_view, lineStyleCount> lineStyles{"solid", "dashed", "dotted"};
constexpr std::array<std::string_view, labelTextCount> labelTexts{"name", "value"};

/// What a name in a list of them stands for; nothing where it is not there.
template <class Named, std::size_t count>
std::optional<Named> findIn(const std::array<std::string_view, count> &names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? std::nullopt : std::optional(static_cast<Named>(found - names.begin()));
}

} // namespace

std::string_view nameOf(Hue hue) { return hues.at(static_cast<std::size_t>(hue)); }
std::optional<Hue> findHue(std::string_view name) { return findIn<Hue>(hues, name); }
std::vector<std::string> hueNames() { return {hues.begin(), hues.end()}; }

std::string_view nameOf(LineStyle style) { return lineStyles.at(static_cast<std::size_t>(style)); }
std::optional<LineStyle> findLineStyle(std::string_view name) { return findIn<LineStyle>(lineStyles, name); }
std::vector<std::string> lineStyleNames() { return {lineStyles.begin(), lineStyles.end()}; }

std::string_view nameOf(LabelText text) { return labelTexts.at(static_cast<std::size_t>(text)); }
std::optional<LabelText> findLabelText(std::string_view name) { return findIn<LabelText>(labelTexts, name); }
std::vector<std::string> labelTextNames() { return {labelTexts.begin(), labelTexts.end()}; }

} // namespace halfspace
