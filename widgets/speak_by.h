// Widgets that are painted whole, told to screen readers.
#pragma once

#include <QAccessible>

namespace halfspace {

/// From now on a screen reader is told of such widgets by a `Spoken`, which is made of one.
template <class Widget, class Spoken> void speakBy() {
  static const bool isTold = [] {
    QAccessible::installFactory([](const QString &, QObject *object) -> QAccessibleInterface * {
      auto *widget = qobject_cast<Widget *>(object);
      return widget ? new Spoken(*widget) : nullptr;
    });
    return true;
  }();
  (void)isTold;
}

} // namespace halfspace
