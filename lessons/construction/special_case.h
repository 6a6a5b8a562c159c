// Special cases: what a small change of one object leads to.
#pragma once

#include "geometry/surd.h"
#include "lessons/construction/condition.h"
#include "lessons/object/object.h"

#include <optional>
#include <string>

namespace halfspace {

/// A special case of a construction that one change of one object leads to: parallel, through a corner, on
/// the plane.
struct SpecialCase {
  Conditions when;      ///< what holds there, by the construction's own names
  std::string sentence; ///< what it is, in plain words: "the ray runs parallel to the plane"
  std::string role;     ///< of the object that changes
  /// What it would be: the nearest of its kind for which that holds. Nothing where that has roots, as no
  /// object has them.
  std::optional<Object> object;
  std::size_t place = 0;           ///< of a list role: which of its objects, counted from 0
  std::optional<Surd> rootedWay{}; ///< where there is no object: the square of the way that it would move
};

} // namespace halfspace
