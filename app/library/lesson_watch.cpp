#include "app/library/lesson_watch.h"

#include "app/work/known_file.h"
#include "lessons/files/read_file.h"
#include "lessons/lesson/lesson.h"

#include <QFileInfo>

#include <chrono>

namespace halfspace {
namespace {

/// Editors that write anew or rename are done within this time.
constexpr std::chrono::milliseconds settlingTime{150};

/// Empty where the file cannot be read: then it is no lesson either.
std::string textOf(const std::filesystem::path &file) {
  const auto text = readFile(file, maxLessonBytes);
  return text ? *text : std::string();
}

} // namespace

LessonWatch::LessonWatch(QObject *parent) : QObject(parent) {
  m_settle.setSingleShot(true);
  m_settle.setInterval(settlingTime);
  connect(&m_settle, &QTimer::timeout, this, &LessonWatch::lookAgain);
  const auto settle = [this] { m_settle.start(); };
  connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, settle);
  connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, settle);
}

void LessonWatch::watch(const std::filesystem::path &file) {
  m_settle.stop();
  m_file = file;
  m_text = textOf(file);
  const QStringList before = m_watcher.files() + m_watcher.directories();
  if (!before.isEmpty())
    m_watcher.removePaths(before);
  // A file that is put in its place is another: the folder tells of it.
  if (const auto path = file.empty() ? std::nullopt : absolutePathOf(file))
    m_watcher.addPaths({*path, QFileInfo(*path).path()});
}

void LessonWatch::lookAgain() {
  const std::string before = m_text;
  watch(std::filesystem::path(m_file));
  if (m_text != before)
    emit changed();
}

} // namespace halfspace
