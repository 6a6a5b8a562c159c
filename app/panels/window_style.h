// The look of the window's panels, from a theme.
#pragma once

#include "widgets/picture/theme.h"

class QApplication;

namespace halfspace {

/// Gives the whole program the theme's palette, sizes and hairlines.
void applyStyle(QApplication &application, const Theme &theme);

} // namespace halfspace
