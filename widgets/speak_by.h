// Widgets that are painted whole, told to screen readers.
#pragma once

#include <QAccessible>
#include <QWidget>

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

/// A screen reader is told another name or description of a widget now. Nothing is made where nobody listens.
inline void tellSpoken(QWidget &widget, QAccessible::Event what) {
  QAccessibleEvent changed(&widget, what);
  QAccessible::updateAccessibility(&changed);
}

} // namespace halfspace
