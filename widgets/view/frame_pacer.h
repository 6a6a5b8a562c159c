// When the next frame of a view is drawn.
#pragma once

#include <QObject>
#include <QTimer>

namespace halfspace {

/// However often a frame is asked for, one is due from the event loop, and none before the last one is seen.
class FramePacer : public QObject {
  Q_OBJECT
public:
  FramePacer();

  void request();
  /// One is being drawn, whether it was due or not, and shows all that was asked for.
  void begin();
  /// It is not seen before `painted`.
  void awaitPaint() { m_awaitsPaint = true; }
  void painted();

signals:
  void due();

private:
  QTimer m_timer;
  bool m_awaitsPaint = false;
  bool m_isWanted = false; ///< one more after that
};

} // namespace halfspace
