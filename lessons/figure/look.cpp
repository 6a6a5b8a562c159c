#include "lessons/figure/look.h"

#include <algorithm>
#include <array>

namespace halfspace {
namespace {

constexpr std::array<std::string_view, hueCount> names{"grey",  "blue",   "orange", "yellow",
                                                       "green", "purple", "pink",   "red"};

} // namespace

std::string_view nameOf(Hue hue) { return names.at(static_cast<std::size_t>(hue)); }

std::optional<Hue> findHue(std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? std::nullopt : std::optional(static_cast<Hue>(found - names.begin()));
}

std::vector<std::string> hueNames() { return {names.begin(), names.end()}; }

} // namespace halfspace
