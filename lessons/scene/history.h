// A session with what was done to its scene.
#pragma once

#include "lessons/scene/session.h"

#include <cstdint>
#include <limits>

namespace halfspace {

/// Who holds a gesture: each has another, and nobody's is none.
enum class GestureToken : std::uint64_t { Nobodys };

/// One thing that was done to a scene, to be undone and done again.
struct HistoryStep {
  std::string description;
  Scene before;
  Scene after;
  bool replaces = false; ///< all of the scene at once: what was in view may be somewhere else altogether
};

/// A session, and the steps in which its scene became what it is. Those that were undone are still there, to
/// be done again, until something else is done. The scene alone has a history: going back and forth in it
/// keeps the step of the lesson and the view.
///
/// Between its beginning and its end all edits of a gesture are one step. Whatever else changes the scene
/// ends it first, as it is: the token that it began with does nothing from then on.
class History {
public:
  History() = default;
  explicit History(Session session) : m_session(std::move(session)) {}

  [[nodiscard]] const Session &session() const { return m_session; }
  /// Another lesson, step or view, or what else is no step of the history.
  void goTo(Session session) { m_session = std::move(session); }

  /// Edits, each of what those before it leave, as one step; none of them where one is refused, and why.
  [[nodiscard]] std::optional<Problem> edit(const std::vector<Edit> &edits, const std::string &description);
  /// Another scene for the same lesson, as one step.
  void replaceScene(Scene scene, const std::string &description);

  /// Goes one step back, or forth again: the step that is undone, or done again; null where there is none.
  const HistoryStep *undo();
  const HistoryStep *redo();
  /// Forgets all steps. The session stays, and is what is saved.
  void clear();

  [[nodiscard]] int count() const { return static_cast<int>(m_steps.size()); } ///< with those undone
  [[nodiscard]] int index() const { return static_cast<int>(m_done); }         ///< how many are done
  /// What the step at an index below `count` does.
  [[nodiscard]] const std::string &text(int index) const {
    return m_steps.at(static_cast<std::size_t>(index)).description;
  }
  /// What undo and redo would undo and do again; nothing where there is no such step.
  [[nodiscard]] std::optional<std::string> undoText() const;
  [[nodiscard]] std::optional<std::string> redoText() const;

  /// Whether the session is as it was saved.
  [[nodiscard]] bool isClean() const { return m_clean == m_done; }
  void setClean() { m_clean = m_done; }
  /// It is saved nowhere, neither now nor after any undo.
  void resetClean() { m_clean = nowhere; }

  [[nodiscard]] GestureToken beginGesture(std::string description);
  /// Whether the edit has changed anything.
  bool moveGesture(GestureToken token, const Edit &edit);
  /// Puts back what was there when the gesture began; it goes on.
  void rewindGesture(GestureToken token);
  /// Makes a step of it, where it has changed anything.
  void endGesture(GestureToken token);
  /// Forgets a gesture that goes on: what it did stays, and is no step.
  void dropGesture() { m_gesture.reset(); }

  [[nodiscard]] bool inGesture() const { return m_gesture.has_value(); }
  /// Whether the gesture of this token goes on.
  [[nodiscard]] bool isHeldBy(GestureToken token) const { return inGesture() && m_holder == token; }
  /// Who holds the gesture that goes on, or held the last one.
  [[nodiscard]] GestureToken holder() const { return m_holder; }
  /// The names of the objects that are others than when the gesture began; none without one.
  [[nodiscard]] std::vector<std::string> movedByGesture() const;

private:
  struct Gesture {
    Scene before;
    std::string description;
  };
  static constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

  /// What was done to the scene that was there before, if anything.
  void record(const Scene &before, const std::string &description, bool replaces = false);

  Session m_session;
  std::vector<HistoryStep> m_steps;
  std::size_t m_done = 0;  ///< of the steps
  std::size_t m_clean = 0; ///< how many were done when it was saved
  std::optional<Gesture> m_gesture;
  GestureToken m_holder = GestureToken::Nobodys; ///< of the newest gesture
};

} // namespace halfspace
