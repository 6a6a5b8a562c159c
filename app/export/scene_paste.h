// Scenes that come from the clipboard.
#pragma once

#include "app/panels/messages.h"

#include <QObject>

namespace halfspace {

class SessionFiles;
class SessionModel;

/// Shows what lies on the clipboard as it would a file: a session, a picture that carries one, or a file
/// that was copied. What is on the screen is asked about first. Plain text is handed on while Explore is
/// open: it may be lines of a scene.
class ScenePaste : public QObject {
  Q_OBJECT
public:
  /// Both must outlive it.
  ScenePaste(const SessionModel &model, SessionFiles &files, Messages messages, QObject *parent);

  /// Says why where there is no scene.
  void paste();

signals:
  void textPasted(const QString &text); ///< nothing else lies there

private:
  const SessionModel &m_model;
  SessionFiles &m_files;
  Messages m_messages;
};

} // namespace halfspace
