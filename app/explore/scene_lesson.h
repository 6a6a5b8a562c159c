// The lesson that a teacher makes of the scene in Explore.
#pragma once

#include "app/panels/messages.h"
#include "lessons/lesson/lesson_draft.h"
#include "widgets/session_model.h"

#include <QAction>

#include <set>

namespace halfspace {

class LessonDialog;
class SessionFiles;

/// Asks what the lesson is to be like and writes it to a file. What was written stays as long as the window
/// lives, and goes on from there.
class SceneLesson : public QObject {
  Q_OBJECT
public:
  /// Model and files must outlive it.
  SceneLesson(SessionModel &model, SessionFiles &files, Messages messages, QObject *parent);

  /// Of a menu: there while Explore has something in its scene.
  [[nodiscard]] QAction &item() { return m_item; }

private:
  void edit();
  /// Asks for a file and writes the lesson to it; false where it is not written.
  bool save(LessonDialog &dialog);
  void offerToOpen();
  /// As it begins, or as it was left, without what has gone from the scene since.
  [[nodiscard]] LessonDraft begun() const;
  /// The draft with an id that no other lesson has.
  [[nodiscard]] LessonDraft withId(LessonDraft draft) const;

  SessionModel &m_model;
  SessionFiles &m_files;
  Messages m_messages;
  QAction m_item;
  LessonDraft m_draft;
  QString m_file;               ///< that was written last
  std::set<std::string> m_ours; ///< the ids of lessons that were written here
};

} // namespace halfspace
