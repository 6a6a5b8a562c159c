// Folders of the user's own data and settings.
#pragma once

#include "lessons/result.h"

#include <QString>

#include <optional>

namespace halfspace {

/// Makes a folder and those above it, where they are missing, for nobody but the user.
[[nodiscard]] std::optional<Problem> makeFolder(const QString &folder);

} // namespace halfspace
