// What the themes are called in the window.
#pragma once

#include <QString>

namespace halfspace {

/// The title of the theme with a name, which is one of `themes`.
[[nodiscard]] QString themeTitle(const QString &name);

} // namespace halfspace
