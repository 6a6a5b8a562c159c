// Keeps unsaved work where a killed program cannot lose it.
#pragma once

#include "app/lesson_progress.h"
#include "lessons/session.h"

#include <QDateTime>
#include <QString>
#include <QTimer>

#include <memory>

class QLockFile;

namespace halfspace {

/// A session that is saved nowhere, and what is needed to go on with it.
struct UnsavedWork {
  Session session;
  std::map<std::string, Session> left; ///< sessions of other lessons that were left with changes
  QString file;                        ///< where Save would write the session; empty: it asks
  LessonProgress progress;
};

/// Writes unsaved work to a file of its own a moment after each change. A lock beside the file tells others
/// that this program lives: what is found without one, or with that of a program that is gone, was left
/// behind.
class Recovery {
public:
  struct Leftover {
    QString path;
    QDateTime written;
    UnsavedWork work;
  };

  /// `folder` may be empty: then nothing is kept.
  explicit Recovery(QString folder = standardFolder());
  ~Recovery();

  /// The folder in the user's data.
  [[nodiscard]] static QString standardFolder();

  /// What programs that have ended left behind, the newest first.
  [[nodiscard]] std::vector<Leftover> leftovers() const;
  /// Goes on with a leftover: its file is this program's from now on. What this program kept before is a
  /// leftover itself then. False where another program was quicker.
  bool adopt(const QString &path);

  /// Keeps this work soon.
  void keep(UnsavedWork work);
  /// Keeps this work before the program ends.
  void keepNow(UnsavedWork work);
  /// There is nothing unsaved any more.
  void forget();

private:
  void write();

  QString m_folder;
  QString m_path;
  std::unique_ptr<QLockFile> m_lock; ///< of that file, from its first writing on
  UnsavedWork m_work;
  QTimer m_timer;
};

} // namespace halfspace
