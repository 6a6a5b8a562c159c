// Worked lines of numbers in their order.
#pragma once

#include "lessons/construction/working.h"

#include <string>
#include <vector>

namespace halfspace {

/// Terms in the order of their numbers, by their names and by their numbers.
[[nodiscard]] WorkingLine sortedLine(std::vector<Term> terms, std::string sentence);

} // namespace halfspace
