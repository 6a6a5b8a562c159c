// New numbers for planes beside others.
#pragma once

#include "lessons/lesson/new_numbers/net.h"

namespace halfspace {

/// The second of two planes, or a later one. The line of two planes has long numbers unless both normals are
/// very short. Now and then it is parallel to the first one; of two it may then be the same, or has a normal
/// as long as the other, so that one is a rational multiple of the other's length.
void drawBeside(const Net &first, bool areTwo, Dice &dice, PlaneObject &plane);

/// The second of three planes that are alone, and the third, behind the last one that there is. They often
/// share no single point: they are along each other, or the third is along the line of the others, through a
/// point of it where the second one's point is such.
void drawOfThree(const Net &first, const Net &last, Dice &dice, PlaneObject &plane);

} // namespace halfspace
