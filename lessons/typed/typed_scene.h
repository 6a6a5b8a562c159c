// A scene as somebody types it, an entry a line.
#pragma once

#include "lessons/result.h"
#include "lessons/scene/scene.h"

namespace halfspace {

/// A scene with lines as `readLine` reads them below what it has, each below those before it. A line without
/// a name gets one (`withName`). Empty lines, and what stands behind a #, say nothing. The problem of the
/// first line with one has its column and what was perhaps meant in its sentence.
[[nodiscard]] Result<Scene> readTypedScene(std::string_view text, const std::string &file,
                                           char decimalMark = '.', Scene above = {});

} // namespace halfspace
