#include "lessons/lesson/new_numbers/several_planes.h"

namespace halfspace {
namespace {

constexpr int specialOnceIn = 6;

void drawAlong(const Net &other, bool mayBeSame, Dice &dice, PlaneObject &plane) {
  plane.normal = other.normal * Rational(dice.sign());
  if (mayBeSame && dice.once(2))
    plane.point = pointOf(other, dice);
}

} // namespace

void drawBeside(const Net &first, bool areTwo, Dice &dice, PlaneObject &plane) {
  plane.normal = dice.direction(1);
  if (dice.once(specialOnceIn))
    return drawAlong(first, areTwo, dice, plane);
  if (!areTwo || !dice.once(specialOnceIn))
    return;
  plane.normal = first.normal;
  plane.normal[dice.between(0, 2)] *= -1;
}

void drawOfThree(const Net &first, const Net &last, Dice &dice, PlaneObject &plane) {
  plane.normal = dice.direction(1);
  const ExactVec3 line = cross(first.normal, last.normal);
  if (isZero(line)) {
    if (dice.once(2))
      drawAlong(first, true, dice, plane);
    else if (dice.once(2))
      plane.point = pointOf(first, dice);
    return;
  }
  if (dice.once(2))
    return;
  plane.normal = last.normal + first.normal * Rational(dice.sign());
  const bool isOnLine = dot(first.normal, ExactVec3(last.at - first.at)) == 0;
  if (isOnLine && dice.once(2))
    plane.point = last.at + line * Rational(dice.sign());
}

} // namespace halfspace
