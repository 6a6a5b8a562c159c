// What nobody sees need not be set in type.
#pragma once

#include <QWidget>

namespace halfspace {

/// Whether a widget is seen once its window is: neither it nor what it lies in was hidden on purpose. One
/// that has just been made and is still to be shown by its layout counts as seen.
inline bool wouldBeSeen(const QWidget &widget) {
  for (const QWidget *each = &widget; each && !each->isWindow(); each = each->parentWidget())
    if (each->isHidden() && each->testAttribute(Qt::WA_WState_ExplicitShowHide))
      return false;
  return true;
}

} // namespace halfspace
