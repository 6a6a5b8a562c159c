// Unsaved work, kept where a killed program cannot lose it.
#pragma once

#include "app/known_file.h"
#include "lessons/reading/problem.h"
#include "lessons/scene/session.h"

#include <QDateTime>
#include <QString>

#include <map>
#include <memory>
#include <optional>

class QLockFile;

namespace halfspace {

/// A session that is saved nowhere, and what is needed to go on with it.
struct UnsavedWork {
  Session session;
  std::map<std::string, Session> left; ///< sessions of other lessons that were left with changes
  std::optional<KnownFile> file;       ///< where Save would write the session; nothing: it asks
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

private:
  QString m_folder;
  QString m_path;
  std::unique_ptr<QLockFile> m_lock; ///< of that file, from its first writing on
};

} // namespace halfspace
