// An entry of a scene as a line that can be typed.
#pragma once

#include "lessons/scene/scene.h"

namespace halfspace {

/// The line from which `readLine` reads the same entry, below the same entries; empty for a mesh, whose shape
/// comes out of a file.
[[nodiscard]] std::string lineFor(const Entry &entry, char decimalMark = '.');

} // namespace halfspace
