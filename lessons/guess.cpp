#include "lessons/guess.h"

#include "lessons/words.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace halfspace {
namespace {

/// Of names longer than this nothing is guessed.
constexpr std::size_t longestGuessed = 100;

/// So many letters are to be added, taken away or changed to get from one text to the other. Neither may be
/// longer than `longestGuessed`.
std::size_t editDistance(std::string_view from, std::string_view to) {
  std::array<std::size_t, longestGuessed + 1> row{};
  std::iota(row.begin(), row.end(), 0U);
  for (std::size_t i = 1; i <= from.size(); ++i) {
    std::size_t diagonal = row[0]; // of the row before
    row[0] = i;
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t changed = diagonal + (from[i - 1] == to[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, changed});
    }
  }
  return row[to.size()];
}

} // namespace

std::string nearestOf(std::string_view wrong, std::span<const std::string> names) {
  if (wrong.size() > longestGuessed)
    return {};
  std::string nearest;
  std::size_t fewest = std::max<std::size_t>(wrong.size() / 3, 1) + 1;
  for (const std::string &name : names)
    if (const std::size_t distance = editDistance(wrong, name.substr(0, longestGuessed));
        distance < fewest && distance < std::max(wrong.size(), name.size())) {
      fewest = distance;
      nearest = name;
    }
  return nearest;
}

std::string withGuess(const std::string &sentence, std::string_view wrong,
                      std::span<const std::string> names) {
  const std::string guess = nearestOf(wrong, names);
  return guess.empty() ? sentence : sentence + " " + words("Perhaps “{guess}” is meant.", {{"guess", guess}});
}

} // namespace halfspace
