#include "widgets/view/frame_pacer.h"

#include <QEvent>

namespace halfspace {

FramePacer::FramePacer(QWidget &view) : m_view(view) {
  m_timer.setSingleShot(true);
  m_rest.setSingleShot(true);
  m_rest.setInterval(restDelay);
  connect(&m_timer, &QTimer::timeout, this, &FramePacer::due);
  connect(&m_rest, &QTimer::timeout, this, &FramePacer::request);
  m_view.installEventFilter(this);
}

void FramePacer::request() {
  if (m_awaitsPaint)
    m_isWanted = true;
  else if (!m_timer.isActive())
    m_timer.start(0);
}

void FramePacer::requestNew() {
  m_isNew = true;
  request();
}

void FramePacer::requestMoving() {
  m_rest.start();
  request();
}

void FramePacer::begin() {
  m_timer.stop();
  m_isWanted = false;
}

void FramePacer::painted() {
  m_awaitsPaint = false;
  if (std::exchange(m_isWanted, false))
    request();
}

bool FramePacer::eventFilter(QObject *watched, QEvent *event) {
  if (watched == &m_view && event->type() == QEvent::Show)
    m_view.window()->installEventFilter(this);
  else if (watched == m_view.window() && event->type() == QEvent::UpdateRequest && m_isNew)
    emit due();
  return QObject::eventFilter(watched, event);
}

} // namespace halfspace
