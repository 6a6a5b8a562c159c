#include "lessons/scene/history.h"

namespace halfspace {

std::optional<Problem> History::edit(const std::vector<Edit> &edits, const std::string &description) {
  endGesture(m_holder);
  Session after = m_session;
  for (const Edit &edit : edits) {
    auto edited = apply(std::move(after), edit);
    if (!edited)
      return edited.problem();
    after = std::move(*edited);
  }
  const Scene before = std::exchange(m_session.scene, std::move(after.scene));
  record(before, description);
  return {};
}

void History::replaceScene(Scene scene, const std::string &description) {
  endGesture(m_holder);
  const Scene before = std::exchange(m_session.scene, std::move(scene));
  record(before, description, true);
}

void History::record(const Scene &before, const std::string &description, bool replaces) {
  if (before == m_session.scene)
    return;
  if (m_clean != nowhere && m_clean > m_done)
    m_clean = nowhere; // no redo leads there any more
  m_steps.resize(m_done);
  m_steps.push_back({description, before, m_session.scene, replaces});
  ++m_done;
}

const HistoryStep *History::undo() {
  endGesture(m_holder);
  if (m_done == 0)
    return nullptr;
  const HistoryStep &step = m_steps[--m_done];
  m_session.scene = step.before;
  return &step;
}

const HistoryStep *History::redo() {
  endGesture(m_holder);
  if (m_done == m_steps.size())
    return nullptr;
  const HistoryStep &step = m_steps[m_done++];
  m_session.scene = step.after;
  return &step;
}

std::optional<std::string> History::undoText() const {
  return m_done > 0 ? std::optional(m_steps[m_done - 1].description) : std::nullopt;
}

std::optional<std::string> History::redoText() const {
  return m_done < m_steps.size() ? std::optional(m_steps[m_done].description) : std::nullopt;
}

void History::clear() {
  m_steps.clear();
  m_done = m_clean = 0;
}

GestureToken History::beginGesture(std::string description) {
  endGesture(m_holder);
  m_holder = static_cast<GestureToken>(static_cast<std::uint64_t>(m_holder) + 1);
  m_gesture = {m_session.scene, std::move(description)};
  return m_holder;
}

bool History::moveGesture(GestureToken token, const Edit &edit) {
  if (!isHeldBy(token))
    return false;
  auto moved = apply(m_session.scene, edit);
  if (!moved || *moved == m_session.scene)
    return false;
  m_session.scene = std::move(*moved);
  return true;
}

void History::rewindGesture(GestureToken token) {
  if (isHeldBy(token))
    m_session.scene = m_gesture->before;
}

void History::endGesture(GestureToken token) {
  if (!isHeldBy(token))
    return;
  const Gesture ended = std::move(*m_gesture);
  m_gesture.reset();
  record(ended.before, ended.description);
}

std::vector<std::string> History::movedByGesture() const {
  std::vector<std::string> names;
  if (!m_gesture)
    return names;
  const NamedList<Entry> &now = m_session.scene.entries;
  for (std::size_t place = 0; place < now.size(); ++place) {
    const Entry &entry = now[place];
    if (const auto &then = m_gesture->before.entries;
        place < then.size() && then.shared(place) == now.shared(place))
      continue; // most are, whatever moves
    if (const Object *before = findObject(m_gesture->before, entry.name))
      if (const auto *object = std::get_if<Object>(&entry.content); object && !(*object == *before))
        names.push_back(entry.name);
  }
  return names;
}

} // namespace halfspace
