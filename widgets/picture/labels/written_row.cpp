#include "widgets/picture/labels/written_row.h"

#include "widgets/picture/screen_shapes.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace halfspace {
namespace {

/// Numbers are thinned out to every so many-th, and then to every ten times as many-th.
constexpr std::array roundSteps{1, 2, 5};
/// Where fewer numbers than this are left, they are no scale.
constexpr std::size_t leastScale = 2;

/// The numbers of a row that are a multiple of a step, by their own numbers.
std::vector<std::size_t> multiplesOf(int step, const std::vector<RowNumber> &row) {
  std::vector<std::size_t> multiples;
  for (std::size_t i = 0; i < row.size(); ++i)
    if (row[i].place % step == 0)
      multiples.push_back(i);
  return multiples;
}

bool areCrowded(const std::vector<std::size_t> &numbers, const std::vector<RowNumber> &row) {
  return std::adjacent_find(numbers.begin(), numbers.end(), [&](std::size_t one, std::size_t next) {
           return overlapArea(row[one].room, row[next].room) > 0;
         }) != numbers.end();
}

/// The numbers that are written, those that cannot be read among them.
std::vector<std::size_t> chosenOf(const std::vector<RowNumber> &row) {
  int last = 0;
  for (const RowNumber &number : row)
    last = std::max(last, std::abs(number.place));
  std::optional<std::vector<std::size_t>> chosen;
  for (int ten = 1; ten <= std::max(last, 1); ten *= 10)
    for (const int round : roundSteps) {
      std::vector<std::size_t> numbers = multiplesOf(round * ten, row);
      if (areCrowded(numbers, row))
        continue;
      const bool areRead =
          std::all_of(numbers.begin(), numbers.end(), [&](std::size_t i) { return row[i].canBeRead; });
      if (areRead && (!chosen || numbers.size() >= leastScale))
        return numbers;
      if (!chosen)
        chosen = std::move(numbers);
    }
  return chosen.value_or(std::vector<std::size_t>());
}

} // namespace

std::vector<bool> writtenOf(const std::vector<RowNumber> &row) {
  std::vector<bool> written(row.size(), false);
  for (const std::size_t number : chosenOf(row))
    written[number] = row[number].canBeRead;
  return written;
}

} // namespace halfspace
