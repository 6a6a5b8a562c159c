// When the next frame of a view is drawn, and how finely.
#pragma once

#include <QTimer>
#include <QWidget>

#include <utility>

namespace halfspace {

/// However often a frame is asked for, one is due from the event loop, and none before the last one is seen.
/// Whatever else a window shows is never seen beside an older picture: where there is something new to be
/// drawn, a frame is due before the window is put together.
class FramePacer : public QObject {
  Q_OBJECT
public:
  /// How long what moves must have rested until it is drawn finely, in milliseconds.
  static constexpr int restDelay = 160;

  /// For a view, in whatever window that is.
  explicit FramePacer(QWidget &view);

  void request();
  /// Something is there to be drawn that was not before.
  void requestNew();
  /// Something moves: it is drawn quickly, and finely once it rests.
  void requestMoving();
  /// Something may move on, or rest.
  void startRest() { m_rest.start(); }
  [[nodiscard]] bool isMoving() const { return m_rest.isActive(); }

  /// One is being drawn, whether it was due or not, and shows all that was asked for.
  void begin();
  /// Whether there is something new to be drawn; it is drawn now.
  [[nodiscard]] bool takeNew() { return std::exchange(m_isNew, false); }
  /// It is not seen before `painted`.
  void awaitPaint() { m_awaitsPaint = true; }
  void painted();

signals:
  void due();

protected:
  bool eventFilter(QObject *watched, QEvent *event) override;

private:
  QWidget &m_view;
  QTimer m_timer;
  QTimer m_rest;
  bool m_awaitsPaint = false;
  bool m_isWanted = false; ///< one more after that
  bool m_isNew = true;
};

} // namespace halfspace
