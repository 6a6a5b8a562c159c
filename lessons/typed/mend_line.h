// What was perhaps meant by a typed line that is wrong.
#pragma once

#include "lessons/scene/scene.h"

namespace halfspace {

/// Lines near to a wrong one that are right, the nearest first, at most so many.
[[nodiscard]] std::vector<std::string> mendsOf(std::string_view line, const Scene &above,
                                               char decimalMark = '.', std::size_t most = 3);

} // namespace halfspace
