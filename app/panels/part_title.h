// What people call the parts of a picture.
#pragma once

#include "widgets/picture/shown_parts.h"

#include <QString>

namespace halfspace {

/// As an item of a menu or a box has it, with a letter to choose it by.
[[nodiscard]] QString partTitle(bool ShownParts::*part);

} // namespace halfspace
