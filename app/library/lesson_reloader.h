// The open lesson, read anew when its file changes.
#pragma once

#include "app/library/lesson_watch.h"
#include "app/panels/messages.h"

namespace halfspace {

class SessionModel;

/// For whoever writes a lesson beside the window that shows it.
class LessonReloader : public QObject {
  Q_OBJECT
public:
  /// The model must outlive it.
  LessonReloader(SessionModel &model, Messages messages, QObject *parent = nullptr);

private:
  void watch();
  void reload(const Result<std::string> &text);

  SessionModel &m_model;
  Messages m_messages;
  LessonWatch m_watch;
};

} // namespace halfspace
