#include "app/option_text.h"

#include "lessons/text.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace halfspace {
namespace {

/// Higher numbers of steps are typing errors.
constexpr std::size_t highestStep = 1000;

/// 4, or 4-6.
std::optional<std::pair<std::size_t, std::size_t>> parseStepRange(std::string_view text) {
  const auto hyphen = text.find('-');
  const auto first = parseCount(text.substr(0, hyphen), highestStep);
  const auto last =
      hyphen == std::string_view::npos ? first : parseCount(text.substr(hyphen + 1), highestStep);
  if (!first || !last || *last < *first)
    return {};
  return std::pair(*first, *last);
}

} // namespace

Problem refused(std::string sentence) { return {std::move(sentence), "", 0, ""}; }

std::optional<double> takePositive(std::string_view &text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || !(value > 0))
    return {};
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

std::optional<double> parsePositive(std::string_view text) {
  const auto value = takePositive(text);
  return text.empty() ? value : std::nullopt;
}

std::optional<std::size_t> parseCount(std::string_view text, std::size_t most) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < 1 || value > most)
    return {};
  return value;
}

std::optional<std::vector<int>> parseSteps(std::string_view text) {
  std::vector<int> steps;
  for (const std::string_view part : partsOf(text, ",")) {
    const auto range = parseStepRange(part);
    if (!range)
      return {};
    for (std::size_t step = range->first; step <= range->second; ++step)
      steps.push_back(static_cast<int>(step));
  }
  std::sort(steps.begin(), steps.end());
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
  return steps;
}

} // namespace halfspace
