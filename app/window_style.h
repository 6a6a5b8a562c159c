// The look of the window's panels, from a theme.
#pragma once

#include "widgets/scene/theme.h"

class QApplication;
class QWidget;

namespace halfspace {

/// Gives the whole program the theme's palette, sizes and hairlines.
void applyStyle(QApplication &application, const Theme &theme);

/// Applies the style anew to a widget one of whose properties has changed.
void repolish(QWidget &widget);

} // namespace halfspace
