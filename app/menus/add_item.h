// An item of a menu.
#pragma once

#include <QMenu>

namespace halfspace {

/// Adds it to the menu; `slot` is called when it is triggered, as long as `on` is there.
template <class Receiver, class Slot>
QAction *addItem(QMenu &menu, const QString &text, const QKeySequence &key, Receiver *on, Slot slot) {
  QAction *action = menu.addAction(text);
  action->setShortcut(key);
  QObject::connect(action, &QAction::triggered, on, slot);
  return action;
}

} // namespace halfspace
