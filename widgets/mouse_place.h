// Where the mouse is, more finely than in whole pixels: Qt 6 calls it otherwise than Qt 5.
#pragma once

#include <QMouseEvent>

namespace halfspace {

/// In the coordinates of the widget that gets the event.
inline QPointF mousePlace(const QMouseEvent &event) {
#if QT_VERSION_MAJOR >= 6
  return event.position();
#else
  return event.localPos();
#endif
}

} // namespace halfspace
