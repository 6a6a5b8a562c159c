// The worked lines in a panel, and a pointer over them.
#pragma once

#include "lessons/construction/worked_lines.h"
#include "lessons/object/object.h"
#include "lessons/term/rewrite.h"
#include "widgets/working/working_block.h"

#include <QApplication>
#include <QMouseEvent>
#include <QtTest>

namespace halfspace::test {

/// The result of one line left out.
inline Fade blankIn(const Working &working, const std::string &line) {
  return {{{line, resultGap(*findLine(working, line))}}, {}};
}

/// QTest::mouseMove delivers nothing on the offscreen platform.
inline void movePointer(WorkingBlock &panel, QPointF position) {
  QMouseEvent move(QEvent::MouseMove, position, Qt::NoButton, Qt::NoButton, Qt::NoModifier);
  QApplication::sendEvent(panel.viewport(), &move);
}

inline void show(WorkingBlock &panel, int width, const Working &working) {
  panel.resize(width, 500);
  panel.show();
  panel.setWorking(working);
}

} // namespace halfspace::test
