// The dashes of a line.
#pragma once

#include <vector>

namespace halfspace {

/// How a line is cut into dashes: the lengths that are drawn and left out in turn, one left out at last;
/// empty for a line that is whole.
using Rhythm = std::vector<double>;

} // namespace halfspace
