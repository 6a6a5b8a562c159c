// Unsaved work, kept where a killed program cannot lose it.
#pragma once

#include "app/work/lesson_works.h"
#include "lessons/result.h"
#include "lessons/scene/session.h"

#include <QDateTime>
#include <QString>

#include <map>
#include <memory>
#include <mutex>
#include <optional>

class QLockFile;

namespace halfspace {

/// A session that is saved nowhere, and what is needed to go on with it.
struct UnsavedWork {
  Session session;
  std::map<std::string, Session> left; ///< sessions of other lessons that were left with changes
  /// Where Save would write the session; null: it asks. Shared, as work is prepared at every change.
  std::shared_ptr<const KnownFile> file;
  /// That are being written; null for none. Shared likewise.
  std::shared_ptr<const LessonWorks> lessons{};
};

/// Keeps unsaved work in a file of its own, which nobody but the user may read. A lock beside the file tells
/// others that this program lives: what is found without one, or with that of a program that is gone, was
/// left behind.
class Recovery {
public:
  struct Leftover {
    QString path;
    QDateTime written;
    UnsavedWork work;
    bool endedItsProgram = false; ///< the program that took it up ended before it was all shown
  };

  /// `folder` may be empty: then nothing can be kept.
  explicit Recovery(QString folder = standardFolder());
  ~Recovery();

  /// The folder in the user's data.
  [[nodiscard]] static QString standardFolder();

  /// What programs that have ended left behind, the newest first.
  [[nodiscard]] std::vector<Leftover> leftovers() const;
  /// Takes up a leftover as it is now: its file is this program's from now on, and marked as being opened.
  /// What this program kept before is a leftover itself then. Nothing where another program was quicker.
  [[nodiscard]] std::optional<UnsavedWork> adopt(const QString &path);
  /// What was taken up is all shown: should the program end, it was not for that.
  void opened();

  /// Keeps this work, or says why it cannot be kept; then what was kept before is still there.
  [[nodiscard]] std::optional<Problem> keep(const UnsavedWork &work);
  /// There is nothing unsaved any more.
  void forget();

  /// What `keepPrepared` would keep: the unsaved work as it is; nothing where nothing is unsaved.
  void prepare(std::optional<UnsavedWork> work);
  /// For the end of a program whose own thread does not come to it; from any thread.
  [[nodiscard]] std::optional<Problem> keepPrepared();

  /// The window is gone: what is kept is for the next start, which need not wait for the end of this program.
  void leave();

private:
  [[nodiscard]] std::optional<Problem> keepLocked(const UnsavedWork &work);
  void removeMark();

  std::mutex m_mutex; ///< of all that follows
  QString m_folder;
  QString m_path;
  std::unique_ptr<QLockFile> m_lock; ///< of that file, from its first writing on
  std::optional<UnsavedWork> m_prepared;
};

} // namespace halfspace
