// Colours of the themes as Qt's.
#pragma once

#include "widgets/picture/theme.h"

#include <QColor>

namespace halfspace {

[[nodiscard]] inline QColor toQColor(Color color) { return {color.red, color.green, color.blue}; }

} // namespace halfspace
