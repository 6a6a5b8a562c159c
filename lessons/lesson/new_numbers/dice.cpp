#include "lessons/lesson/new_numbers/dice.h"

#include <utility>

namespace halfspace {
namespace {

constexpr int lowestPosition = -3;
constexpr int highestPosition = 6;

/// Whole numbers a, b, c for which √(a² + b² + c²) is whole too.
constexpr std::array<std::array<int, 3>, 3> wholeLengths{{{1, 2, 2}, {2, 3, 6}, {0, 3, 4}}};

} // namespace

int Dice::between(int low, int high) {
  return low + static_cast<int>(m_engine() % static_cast<std::uint64_t>(high - low + 1));
}

ExactVec3 Dice::position() {
  const auto number = [this] { return between(lowestPosition, highestPosition); };
  return {number(), number(), number()};
}

ExactVec3 Dice::direction(int longest) {
  ExactVec3 vector{};
  do
    vector = {between(-longest, longest), between(-longest, longest), between(-longest, longest)};
  while ((vector.x == 0) + (vector.y == 0) + (vector.z == 0) > 1);
  return vector;
}

ExactVec3 Dice::normal() {
  const int last = static_cast<int>(wholeLengths.size()) - 1;
  return turned(wholeLengths.at(static_cast<std::size_t>(between(0, last))));
}

ExactVec3 Dice::shortestNormal() { return turned(wholeLengths.front()); }

ExactVec3 Dice::shortNormal() { return turned(once(2) ? wholeLengths.front() : wholeLengths.back()); }

ExactVec3 Dice::turned(std::array<int, 3> numbers) {
  for (std::size_t last = numbers.size() - 1; last > 0; --last)
    std::swap(numbers[last], numbers.at(static_cast<std::size_t>(between(0, static_cast<int>(last)))));
  return {sign() * numbers[0], sign() * numbers[1], sign() * numbers[2]};
}

} // namespace halfspace
