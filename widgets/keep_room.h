// Room for what is hidden.
#pragma once

#include <QWidget>

namespace halfspace {

/// Whether a widget's room stays when it is hidden, so that others do not jump when it is shown.
inline void keepRoom(QWidget &widget, bool kept) {
  QSizePolicy policy = widget.sizePolicy();
  policy.setRetainSizeWhenHidden(kept);
  widget.setSizePolicy(policy);
}

} // namespace halfspace
