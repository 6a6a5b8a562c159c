// A mouse over a widget: QTest::mouseMove delivers nothing on the offscreen platform, and holds no button.
#pragma once

#include <QApplication>
#include <QMouseEvent>
#include <QtTest>

namespace halfspace::test {

inline void movePointer(QWidget &widget, QPoint to, Qt::MouseButtons held = Qt::NoButton,
                        Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  QMouseEvent move(QEvent::MouseMove, to, widget.mapToGlobal(to), Qt::NoButton, held, modifiers);
  QApplication::sendEvent(&widget, &move);
}

/// Presses, moves and releases the left button.
inline void dragPointer(QWidget &widget, QPoint from, QPoint to) {
  QTest::mousePress(&widget, Qt::LeftButton, {}, from);
  movePointer(widget, to, Qt::LeftButton);
  QTest::mouseRelease(&widget, Qt::LeftButton, {}, to);
}

} // namespace halfspace::test
