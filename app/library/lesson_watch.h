// Tells when the file of a lesson changes.
#pragma once

#include "lessons/result.h"

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include <filesystem>
#include <string>

namespace halfspace {

/// Watches one file, also while editors put another in its place.
class LessonWatch : public QObject {
  Q_OBJECT
public:
  explicit LessonWatch(QObject *parent = nullptr);

  /// Watches this file from now on; `text` is what was read from it. An empty path: none.
  void watch(const std::filesystem::path &file, const std::string &text);

signals:
  /// The file holds another text than before, or cannot be read.
  void changed(const halfspace::Result<std::string> &text);

private:
  void addPaths();
  void lookAgain();

  std::filesystem::path m_file;
  std::string m_text; ///< as it was last found; empty where it cannot be read: then it is no lesson either
  QFileSystemWatcher m_watcher;
  QTimer m_settle; ///< editors write in several goes
};

} // namespace halfspace
