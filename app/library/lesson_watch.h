// Tells when the file of a lesson changes.
#pragma once

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

  /// Watches this file from now on, as it stands there.
  void watch(const std::filesystem::path &file);

signals:
  void changed(); ///< the file holds another text than before, or cannot be read

private:
  void lookAgain();

  std::filesystem::path m_file;
  std::string m_text; ///< as it was last found
  QFileSystemWatcher m_watcher;
  QTimer m_settle; ///< editors write in several goes
};

} // namespace halfspace
