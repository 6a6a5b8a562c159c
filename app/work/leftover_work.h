// Work that an earlier run left unsaved, taken up again.
#pragma once

#include "app/panels/messages.h"
#include "app/work/recovery.h"

#include <QTimer>

class QMenu;

namespace halfspace {

class Autosave;
class SceneDrawing;
class SessionFiles;
class SessionModel;
class UnfinishedInput;

/// Goes on with it, offers it, or lists it. What is unsaved here becomes a leftover itself then.
class LeftoverWork : public QObject {
  Q_OBJECT
public:
  /// All must outlive it.
  LeftoverWork(SessionModel &model, SessionFiles &files, Autosave &autosave, UnfinishedInput &input,
               const SceneDrawing &drawing, Messages messages);

  /// Goes on with the newest work that an earlier run left unsaved, if there is any. Where that run ended
  /// while it opened the work, it is only offered. For the event loop: it may ask.
  void restoreNewest();
  /// Offers unsaved changes to the file that the window began with, and tells where other work waits. For the
  /// event loop: it may ask.
  void offer();
  /// An item for each piece of such work that takes it up.
  void fillMenu(QMenu &menu);

private:
  void takeUp(const QString &path);
  void offerAgain(const Recovery::Leftover &leftover);
  [[nodiscard]] QString nameOf(const Recovery::Leftover &leftover) const;

  SessionModel &m_model;
  SessionFiles &m_files;
  Autosave &m_autosave;
  UnfinishedInput &m_input;
  const SceneDrawing &m_drawing;
  Messages m_messages;
  QTimer m_openedTimer; ///< what was taken up counts as opened a moment after it is shown
};

} // namespace halfspace
