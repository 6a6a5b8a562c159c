// The file of the session: opened, saved, and what is asked before it is left.
#pragma once

#include "app/panels/messages.h"
#include "app/work/lesson_works.h"
#include "widgets/session_model.h"

#include <QObject>

#include <memory>

namespace halfspace {

class UnfinishedInput;

/// Knows the file that Save writes, and whether the session on the screen has changes that it does not hold.
class SessionFiles : public QObject {
  Q_OBJECT
public:
  /// `file` is where Save writes the session that the model begins with (null: Save asks). Model and input
  /// must outlive it.
  SessionFiles(SessionModel &model, UnfinishedInput &input, Messages messages,
               std::shared_ptr<const KnownFile> file);

  /// Starts with a session; `file` is where Save writes it (null: Save asks).
  void startWith(const Session &session, std::shared_ptr<const KnownFile> file = {});
  /// Starts with an empty scene in Explore, once the session may be left.
  void startNew();
  /// Opens a .halfspace file, the .md file of a lesson, or a picture that carries a session, which is no file
  /// for Save to write; on failure says why and leaves the session as it is.
  void open(const QString &file);
  /// Asks for a file to be opened, once the session may be left.
  void askAndOpen();

  /// Writes the session to its file, or asks for one. Asks as well where the file is not any more as this
  /// window knows it. False where it is not saved.
  bool save();
  /// Asks for a file and writes the session to it.
  bool saveAs();
  /// Writes the session; on failure says why and returns false.
  bool saveTo(const QString &file);

  /// The session is another work than the one that the file holds: Save asks.
  void forgetFile();

  /// Where Save writes; null: it asks.
  [[nodiscard]] const std::shared_ptr<const KnownFile> &file() const { return m_file; }
  /// What the session is called: its file, or its lesson where it has none.
  [[nodiscard]] QString name() const;
  /// Whether Save may write the session to the window's file: another lesson asks for a file of its own.
  [[nodiscard]] bool belongsToFile() const;
  /// Whether something in the session on the screen would be lost.
  [[nodiscard]] bool hasChanges() const;

  /// The lessons that are being written. That of Explore goes with its scene.
  [[nodiscard]] const LessonWorks &lessonWorks() const { return *m_works; }
  [[nodiscard]] const std::shared_ptr<const LessonWorks> &sharedLessonWorks() const { return m_works; }
  void setLessonWorks(LessonWorks works);

  /// Whether another session may take the place of this one: what is typed is entered, changes are asked
  /// about.
  [[nodiscard]] bool mayLeave();
  /// The same before the window closes. Only changes to a file are asked about, and where they are to be
  /// dropped the session is as in its file again: what has no file is kept elsewhere.
  [[nodiscard]] bool mayClose();

signals:
  void changed(); ///< the session has another file, its file holds something else, or a lesson is written

private:
  /// Enters what is typed, to save it; false, with a complaint, where it cannot be entered.
  bool finishInput();
  [[nodiscard]] bool askToKeepChanges();
  /// Whether what is written of a lesson of the scene in Explore may go.
  [[nodiscard]] bool askToDropLesson();
  /// What is written of the scene in Explore goes with that, where another session comes; what is not saved
  /// stays, if nobody was asked.
  void dropLesson(const Session &coming);
  bool askToReplace(const KnownFile &file);
  /// Back to what the session's file holds.
  void dropChanges();

  SessionModel &m_model;
  UnfinishedInput &m_input;
  Messages m_messages;
  std::shared_ptr<const KnownFile> m_file;
  std::shared_ptr<const LessonWorks> m_works = std::make_shared<const LessonWorks>();
};

} // namespace halfspace
