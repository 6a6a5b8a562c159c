// New numbers for the objects of a scene, whether its results become short with them or not.
#pragma once

#include "lessons/lesson/new_numbers/dice.h"
#include "lessons/scene/scene.h"

#include <string>
#include <vector>

namespace halfspace {

/// Gives the objects of these names whole and short numbers that they did not have; one keeps those that it
/// has where there is no luck. Rays and points aim at planes, triangles, lines and faces, so that they meet
/// them in whole points; where a vector shines past points onto a plane, the first of them is a lamp that
/// shines past the others. `keepsCornersOnALine`: a triangle whose corners are on one line is drawn so again.
void renewAll(Scene &scene, const std::vector<std::string> &names, Dice &dice,
              bool keepsCornersOnALine = false);

} // namespace halfspace
