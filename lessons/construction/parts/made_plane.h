// Planes that constructions make, as all of them write and draw them.
#pragma once

#include "lessons/construction/taught.h"
#include "lessons/object/kinds/plane.h"

#include <string>

namespace halfspace {

/// The letters of a plane that a construction makes, by its name there, through a point that is known
/// otherwise.
[[nodiscard]] PlaneTerms madePlane(const Naming &naming, const std::string &name, const Term &point,
                                   const TermValue &normal);

/// The plane that the letters stand for.
[[nodiscard]] PlaneObject planeOf(const PlaneTerms &plane);

/// Draws its patch, with the equation behind its name, its point and its normal ≠ 0. A look tells it from
/// another plane that is made with it.
void addMadePlane(Figure &figure, const Naming &naming, const std::string &name, const PlaneTerms &plane,
                  const Look &look = {});

/// d = −n·P0, by the construction's letter for it.
[[nodiscard]] WorkingLine constantLine(const Term &d, const PlaneTerms &plane, std::string sentence);

/// 0 = n·P + d, an equation for a learner to find. The result is the patch that is drawn.
[[nodiscard]] WorkingLine equationLine(const Naming &naming, const std::string &name, const PlaneTerms &plane,
                                       const Term &d);

/// (a, b, c, d) of ax + by + cz + d = 0.
[[nodiscard]] ToldValue coefficientsValue(const PlaneTerms &plane);

} // namespace halfspace
