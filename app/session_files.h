// Writing sessions to files.
#pragma once

#include "lessons/problem.h"
#include "lessons/session.h"

#include <QString>

#include <optional>

namespace halfspace {

/// Writes a .halfspace file atomically: the whole session, or the file stays as it was and the problem says
/// why.
[[nodiscard]] std::optional<Problem> writeSessionFile(const Session &session, const QString &file);

} // namespace halfspace
