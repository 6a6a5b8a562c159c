// Scenes that come from the clipboard.
#pragma once

#include "app/panels/messages.h"

#include <QObject>

namespace halfspace {

class SessionFiles;

/// Shows what lies on the clipboard as it would a file: a session, a picture that carries one, or a file
/// that was copied. What is on the screen is asked about first.
class ScenePaste : public QObject {
  Q_OBJECT
public:
  /// The files must outlive it.
  ScenePaste(SessionFiles &files, Messages messages, QObject *parent);

  /// Says why where there is no scene.
  void paste();

private:
  SessionFiles &m_files;
  Messages m_messages;
};

} // namespace halfspace
