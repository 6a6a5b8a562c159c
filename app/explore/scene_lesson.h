// The lesson that a teacher makes of a scene.
#pragma once

#include "app/explore/checked_draft.h"
#include "app/panels/messages.h"
#include "app/work/lesson_works.h"
#include "widgets/session_model.h"

#include <QAction>

#include <optional>
#include <string>

namespace halfspace {

class LessonDialog;
class OwnLessonFolders;
class SessionFiles;

/// Asks what the lesson is to be like, writes it to a file, and puts it into the library. In Explore it is of
/// the scene there; a lesson that was made so can be made anew where it is open. What was written and not
/// saved is kept among the unsaved work, and goes on from there.
class SceneLesson : public QObject {
  Q_OBJECT
public:
  /// All must outlive it.
  SceneLesson(SessionModel &model, SessionFiles &files, OwnLessonFolders &folders, Messages messages,
              QObject *parent);

  /// Of a menu: there while Explore has something in its scene, and in lessons that were made so.
  [[nodiscard]] QAction &item() { return m_item; }
  /// The scene of a lesson is taken to Explore: what is made there goes on with the lesson, if that was made
  /// so. What is written there and not saved stays.
  void goOnWith(const Lesson &lesson);

private:
  /// What a lesson begins with.
  struct Start {
    Evaluation scene;
    CameraView camera;
    int step = 0; ///< that is written first
  };

  void enable();
  void edit();
  /// What a lesson can be gone on with, as it was left or as its file has it; nothing where it was not made
  /// so.
  [[nodiscard]] std::optional<LessonWork> workOn(const Lesson &lesson) const;
  /// That of the scene in Explore: with one step at least, and without what has gone from the scene.
  [[nodiscard]] LessonWork workInExplore() const;
  /// Keeps what is written of a lesson; nothing: it is as its file has it.
  void keep(const std::string &lesson, const std::optional<LessonWork> &work);
  /// Lets the user write; false where nothing was saved.
  bool write(const std::string &lesson, LessonWork &work, const Start &start);
  /// A draft as it would stand in a file: as the same lesson where it stands in that already, else as one of
  /// its own.
  [[nodiscard]] CheckedDraft checkedIn(const QString &file, LessonDraft draft, const LessonWork &work,
                                       const Start &start) const;
  /// Writes the lesson to its file, or asks for one; false where it is not written.
  bool save(LessonDialog &dialog, LessonWork &work, const Start &start);
  /// Whether the user wants to go on, and not to cancel.
  [[nodiscard]] static bool askAbove(LessonDialog &dialog, const QString &question,
                                     QMessageBox::StandardButton goOn);
  [[nodiscard]] QString askForFile(LessonDialog &dialog, const LessonWork &work) const;
  void offerToOpen(const KnownFile &file);
  /// An id for a title that no other lesson has.
  [[nodiscard]] std::string freshId(const std::string &title) const;

  SessionModel &m_model;
  SessionFiles &m_files;
  OwnLessonFolders &m_folders;
  Messages m_messages;
  QAction m_item;
};

} // namespace halfspace
