// A scene as somebody types it, an entry a line.
#pragma once

#include "lessons/result.h"
#include "lessons/scene/scene.h"

namespace halfspace {

/// The scene of lines as `readLine` reads them, each below those before it. Empty lines, and what stands
/// behind a #, say nothing. The problem of the first line with one has its column and what was perhaps meant
/// in its sentence.
[[nodiscard]] Result<Scene> readTypedScene(std::string_view text, const std::string &file,
                                           char decimalMark = '.');

} // namespace halfspace
