#include "lessons/lesson/short_move.h"

#include "lessons/lesson/lesson.h"
#include "lessons/object/coordinate_limits.h"

#include <algorithm>

namespace halfspace {
namespace {

/// A move may be so many times as long as the least one, and a step more.
constexpr int longestOfLeast = 2;

/// The index of the one coordinate that a change moves; nothing where it moves several, or is of a bound
/// object, whose numbers are freedoms.
std::optional<std::size_t> movedCoordinate(const Object &now, const Object &there) {
  std::optional<std::size_t> moved;
  for (std::size_t i = 0; i < now.size(); ++i)
    if (now[i] != there[i]) {
      if (moved || numbersIn(coordinatesOf(now)[i].role) == 1)
        return {};
      moved = i;
    }
  return moved;
}

/// The longest of its denominators, counted in steps; 1 on the grid.
Rational offGrid(const ExactVec3 &value, const Rational &step) {
  Rational longest = 1;
  for (int axis = 0; axis < 3; ++axis)
    longest = std::max(longest, Rational(value[axis] / step).denominator());
  return longest;
}

/// Values that may lead there too: along each axis to the plane that the least way meets at a right angle,
/// and the places of the grid around its end.
std::vector<ExactVec3> valuesToTry(const ExactVec3 &now, const ExactVec3 &there, const Rational &step) {
  std::vector<ExactVec3> values{there};
  const ExactVec3 way = there - now;
  ExactVec3 rounded;
  for (int axis = 0; axis < 3; ++axis) {
    rounded[axis] = roundToMultiple(there[axis], step);
    if (way[axis] == 0)
      continue;
    ExactVec3 along = now;
    along[axis] += dot(way, way) / way[axis];
    values.push_back(along);
  }
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        values.push_back(rounded + ExactVec3(x, y, z) * step);
  return values;
}

} // namespace

ChangeObject shortMoveTo(const NearSpecialCase &near, const Scene &scene, const Rational &step) {
  const ChangeObject &least = *near.change;
  const Object &now = *findObject(scene, least.name);
  const auto index = movedCoordinate(now, least.value);
  if (!index)
    return least;
  Conditions conditions = near.when;
  for (Condition &condition : conditions)
    condition.value = near.entry + "." + condition.value;
  const Evaluation before = evaluate(scene);
  const auto isThere = [&](const Object &moved) {
    Scene after = scene;
    setObject(after, least.name, moved);
    const Evaluation evaluation = evaluate(after, before);
    return std::all_of(conditions.begin(), conditions.end(),
                       [&](const Condition &condition) { return holds(condition, evaluation); });
  };
  const ExactVec3 leastWay = least.value[*index] - now[*index];
  const Rational farthest = longestOfLeast * longestOfLeast * dot(leastWay, leastWay) + step * step;

  struct Candidate {
    ExactVec3 value;
    Rational offGrid;
    Rational square; ///< of the way
  };
  std::vector<Candidate> candidates;
  for (const ExactVec3 &value : valuesToTry(now[*index], least.value[*index], step)) {
    const ExactVec3 way = value - now[*index];
    if (const Rational square = dot(way, way); square <= farthest)
      candidates.push_back({value, offGrid(value, step), square});
  }
  std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate &a, const Candidate &b) {
    return a.offGrid < b.offGrid || (a.offGrid == b.offGrid && a.square < b.square);
  });
  for (const Candidate &candidate : candidates) {
    ChangeObject change = least;
    change.value[*index] = candidate.value;
    if (!refusedCoordinateOf(change.value) && isThere(change.value))
      return change;
  }
  return least;
}

} // namespace halfspace
