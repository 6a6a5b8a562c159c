// The history of the window's session, which tells what becomes of it.
#pragma once

#include "lessons/scene/history.h"

#include <QObject>

namespace halfspace {

/// Does to a session what a History does, and says so. Whoever shows the session goes by its signals.
class SessionHistory : public QObject, private History {
  Q_OBJECT

public:
  using QObject::QObject;

  using History::count;
  using History::index;
  using History::inGesture;
  using History::isClean;
  using History::isHeldBy;
  using History::movedByGesture;
  using History::redoText;
  using History::session;
  using History::text;
  using History::undoText;

  /// An edit that stands on its own: one step. Why it is refused; else empty.
  QString edit(const Edit &edit, const QString &description) { return editTogether({edit}, description); }
  /// Several, each of what those before it leave: one step, or none of them where one is refused.
  QString editTogether(const std::vector<Edit> &edits, const QString &description);
  /// Another scene for the same lesson and step, as one step.
  void replaceScene(Scene scene, const QString &description);

  /// What goes on under the hand ends first, and is what is undone.
  void undo();
  void redo();
  /// The session is as it is saved; or saved nowhere, now and after any undo.
  void setClean();
  void resetClean();

  /// Between beginGesture and endGesture all edits are one step; cancelGesture restores what was there
  /// before. Whatever else changes the scene, begins a gesture or leaves the lesson ends this one first, as
  /// it is: see History.
  [[nodiscard]] GestureToken beginGesture(const QString &description);
  void moveGesture(GestureToken token, const Edit &edit);
  void endGesture(GestureToken token);
  void cancelGesture(GestureToken token);

  /// Where the scene is looked at from now; nothing: as the lesson begins. No step, and no change.
  void setView(const std::optional<ChosenView> &view);

  // For the owner of the session alone:
  /// Another session is shown, which is no step and is not told here.
  using History::goTo;
  /// Something else is to be done: a gesture that goes on ends, as it is.
  void settleGesture();
  /// The same for what brings another history: nothing is recorded.
  void dropGesture();
  /// The history begins anew, with a session that is saved as it is, or nowhere.
  void beginAnew(bool isSaved);

signals:
  /// Before all that it brings about. `replaced`: all of the scene is another one at once.
  void sceneChanged(const halfspace::Session &before, bool replaced);
  void stepsChanged();   ///< there are other steps to be undone or done again
  void cleanChanged();   ///< the session is not any more as it is saved, or is again
  void gestureEnded();   ///< before gestureChanged, when a step was made of what it did
  void gestureChanged(); ///< one has begun, or ended in whatever way
  void gestureSettled(); ///< a gesture has ended because something else was done

private:
  void finishGesture(GestureToken token);
  /// Tells what has become of the history since it was told last.
  void tell();

  std::pair<int, int> m_toldSteps; ///< how many are done, and how many there are
  bool m_toldClean = true;
};

} // namespace halfspace
