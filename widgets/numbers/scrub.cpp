#include "widgets/numbers/scrub.h"

#include <QMouseEvent>
#include <QWidget>

#include <cmath>
#include <utility>

namespace halfspace {
namespace {

// In pixels.
constexpr int pixelsPerStep = 8;
/// A click may tremble so much.
constexpr int scrubSlop = 4;

} // namespace

Scrub::Scrub(QWidget &widget) : m_widget(widget) {}

void Scrub::press(const QMouseEvent &event) {
  m_isPressed = true;
  m_pressedAt = event.pos();
}

void Scrub::move(const QMouseEvent &event) {
  if (!m_isPressed)
    return;
  const int way = event.pos().x() - m_pressedAt.x();
  if (!m_isScrubbing && std::abs(way) > scrubSlop) {
    m_isScrubbing = true;
    m_widget.grabKeyboard();
    emit started();
  }
  if (m_isScrubbing)
    emit moved(way / pixelsPerStep);
}

void Scrub::end(bool keep) {
  m_isPressed = false;
  if (!std::exchange(m_isScrubbing, false))
    return;
  m_widget.releaseKeyboard();
  emit ended(keep);
}

} // namespace halfspace
