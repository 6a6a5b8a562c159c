// The icons of the scene's tools, drawn in the theme's ink at any size.
#pragma once

#include <QIcon>

namespace halfspace {

enum class ToolIcon { Home, AlongPlane, Fit, Numbers, Contents };

[[nodiscard]] QIcon iconOf(ToolIcon tool, const QColor &ink);

} // namespace halfspace
