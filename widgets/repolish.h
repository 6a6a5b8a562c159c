// Looks that depend on a property.
#pragma once

class QWidget;

namespace halfspace {

/// Applies the style anew to a widget one of whose properties has changed.
void repolish(QWidget &widget);

} // namespace halfspace
