#include "widgets/session_history.h"

#include <utility>

namespace halfspace {

QString SessionHistory::editTogether(const std::vector<Edit> &edits, const QString &description) {
  settleGesture();
  const Session before = session();
  if (const auto refused = History::edit(edits, description.toStdString()))
    return QString::fromStdString(refused->sentence);
  emit sceneChanged(before, false);
  tell();
  return {};
}

void SessionHistory::replaceScene(Scene scene, const QString &description) {
  settleGesture();
  const Session before = session();
  History::replaceScene(std::move(scene), description.toStdString());
  emit sceneChanged(before, !(session() == before));
  tell();
}

void SessionHistory::undo() {
  settleGesture();
  const Session before = session();
  const HistoryStep *undone = History::undo();
  emit sceneChanged(before, undone && undone->replaces);
  tell();
}

void SessionHistory::redo() {
  settleGesture();
  const Session before = session();
  const HistoryStep *redone = History::redo();
  emit sceneChanged(before, redone && redone->replaces);
  tell();
}

void SessionHistory::setClean() {
  History::setClean();
  tell();
}

void SessionHistory::resetClean() {
  History::resetClean();
  tell();
}

void SessionHistory::beginAnew(bool isSaved) {
  History::clear();
  if (!isSaved)
    History::resetClean();
  tell();
}

GestureToken SessionHistory::beginGesture(const QString &description) {
  settleGesture();
  const GestureToken token = History::beginGesture(description.toStdString());
  emit gestureChanged(); // whoever hears it may begin another
  return token;
}

void SessionHistory::moveGesture(GestureToken token, const Edit &edit) {
  const Session before = session();
  if (History::moveGesture(token, edit))
    emit sceneChanged(before, false);
}

void SessionHistory::endGesture(GestureToken token) {
  if (isHeldBy(token))
    finishGesture(token);
}

void SessionHistory::cancelGesture(GestureToken token) {
  if (!isHeldBy(token))
    return;
  const Session before = session();
  rewindGesture(token);
  emit sceneChanged(before, false); // first: whoever hears that the gesture has ended sees what is left of it
  finishGesture(token);
}

void SessionHistory::setView(const std::optional<ChosenView> &view) {
  Session seen = session();
  seen.view = view;
  goTo(std::move(seen));
}

void SessionHistory::settleGesture() {
  if (!inGesture())
    return;
  finishGesture(holder());
  emit gestureSettled();
}

void SessionHistory::dropGesture() {
  if (!inGesture())
    return;
  History::dropGesture();
  emit gestureChanged();
  emit gestureSettled();
}

void SessionHistory::finishGesture(GestureToken token) {
  History::endGesture(token);
  emit gestureEnded();
  emit gestureChanged();
  tell();
}

void SessionHistory::tell() {
  const std::pair steps(index(), count());
  const bool isOther = std::exchange(m_toldSteps, steps) != steps;
  if (std::exchange(m_toldClean, isClean()) != isClean())
    emit cleanChanged();
  if (isOther)
    emit stepsChanged();
}

} // namespace halfspace
