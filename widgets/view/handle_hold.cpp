#include "widgets/view/handle_hold.h"
#include "widgets/view/staged_scene.h"

#include "lessons/scene/change_words.h"

#include <utility>

namespace halfspace {

void HandleHold::begin(const Handle &handle, DragMode mode, glm::dvec2 pixel) {
  // First: where a gesture from elsewhere ends by this, all is let go of.
  m_token =
      m_model.history().beginGesture(QString::fromStdString(wordsForMoving(m_model.session().scene, handle)));
  m_drag.emplace(stagedScene(m_model, m_model.stage()), handle, mode, pixel, askedOf(m_model, handle));
}

std::optional<DragMode> HandleHold::mode() const {
  return m_drag ? std::optional(m_drag->mode()) : std::nullopt;
}

void HandleHold::setMode(DragMode mode) {
  if (!m_drag || isOwn(m_drag->mode()))
    return;
  m_drag->setMode(mode);
  emit modeChanged();
}

void HandleHold::pointTo(glm::dvec2 pixel, bool isSuspended) {
  m_pointer = pixel;
  setSuspended(isSuspended);
}

void HandleHold::setSuspended(bool suspended) {
  m_isSuspended = suspended;
  if (!m_pointer)
    return;
  m_isPending = true;
  emit pointed();
}

void HandleHold::follow(const View &view) {
  if (!m_drag || !std::exchange(m_isPending, false))
    return;
  emit aboutToMove();
  const auto move = m_drag->moveTo(*m_pointer, m_model.snapping().dragStep(m_isSuspended), view);
  if (!move)
    return;
  setCaught(move->caught); // first: whoever takes up the outcome tells it
  m_model.history().moveGesture(
      m_token, ChangeObject{m_drag->handle().object, fromStage(move->object, m_model.stage())});
  emit moved();
}

void HandleHold::setCaught(const std::string &caught) {
  if (std::exchange(m_caught, caught) != caught)
    emit caughtChanged();
}

void HandleHold::end(bool stays) {
  if (stays) {
    ++m_dragCount;
    m_model.history().endGesture(m_token);
  } else {
    m_model.history().cancelGesture(m_token);
  }
}

void HandleHold::letGo() {
  m_drag.reset();
  m_pointer.reset();
  m_isPending = false;
  setCaught({}); // what is typed or undone next may make it untrue
}

} // namespace halfspace
