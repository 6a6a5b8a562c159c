// The folders of the user's own lessons.
#pragma once

#include "app/panels/messages.h"

#include <QObject>
#include <QStringList>

class QMenu;

namespace halfspace {

class LearnerProgress;
class SessionModel;

/// Adds the lessons of folders to the library, and takes them away again.
class OwnLessonFolders : public QObject {
  Q_OBJECT
public:
  /// Model and progress must outlive it.
  OwnLessonFolders(SessionModel &model, LearnerProgress &progress, Messages messages,
                   QObject *parent = nullptr);

  /// The folders whose lessons are in the library already.
  void setFolders(const QStringList &folders) { m_folders = folders; }
  [[nodiscard]] const QStringList &folders() const { return m_folders; }
  /// Adds the lessons of a folder, from now on at every start.
  void add(const QString &folder);
  /// Takes them away again; a lesson that is open stays.
  void remove(const QString &folder);
  /// An item that asks for a folder, and one for each folder that removes it.
  void fillMenu(QMenu &menu);

private:
  void askAndAdd();

  SessionModel &m_model;
  LearnerProgress &m_progress;
  Messages m_messages;
  QStringList m_folders;
};

} // namespace halfspace
