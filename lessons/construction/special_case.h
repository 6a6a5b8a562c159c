// Special cases: what a small change of one object leads to.
#pragma once

#include "lessons/object/object.h"

#include <string>

namespace halfspace {

/// A special case of a construction that one change of one object leads to: parallel, through a corner, on
/// the plane.
struct SpecialCase {
  std::string when;      ///< what holds there, as tasks say it: `case = parallel`, `t = 0`
  std::string sentence;  ///< what it is, in plain words: "the ray runs parallel to the plane"
  std::string role;      ///< of the object that changes
  Object object;         ///< what it would be: the nearest of its kind for which that holds
  std::size_t place = 0; ///< of a list role: which of its objects, counted from 0
};

} // namespace halfspace
