// Files of the program's own that cannot be read any more.
#pragma once

#include "lessons/result.h"

#include <QString>

namespace halfspace {

/// Gives a file another name beside it, so that nothing is written over what may still be in it:
/// progress.json becomes progress-damaged.json, or progress-damaged-2.json where something has that name. The
/// new path.
[[nodiscard]] Result<QString> putAside(const QString &file);

} // namespace halfspace
