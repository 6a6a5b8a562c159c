#include "app/library/lesson_watch.h"

#include "app/work/known_file.h"
#include "lessons/files/read_file.h"
#include "lessons/lesson/lesson.h"

#include <QFileInfo>

#include <chrono>
#include <utility>

namespace halfspace {
namespace {

/// Editors that write anew or rename are done within this time.
constexpr std::chrono::milliseconds settlingTime{150};

} // namespace

LessonWatch::LessonWatch(QObject *parent) : QObject(parent) {
  m_settle.setSingleShot(true);
  m_settle.setInterval(settlingTime);
  connect(&m_settle, &QTimer::timeout, this, &LessonWatch::lookAgain);
  const auto settle = [this] { m_settle.start(); };
  connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, settle);
  connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, settle);
}

void LessonWatch::watch(const std::filesystem::path &file, const std::string &text) {
  m_text = text;
  if (file == m_file)
    return;
  m_settle.stop();
  m_file = file;
  addPaths();
}

void LessonWatch::addPaths() {
  const QStringList before = m_watcher.files() + m_watcher.directories();
  if (!before.isEmpty())
    m_watcher.removePaths(before);
  // A file that is put in its place is another: the folder tells of it.
  if (const auto path = m_file.empty() ? std::nullopt : absolutePathOf(m_file))
    m_watcher.addPaths({*path, QFileInfo(*path).path()});
}

void LessonWatch::lookAgain() {
  addPaths();
  const auto text = readFile(m_file, maxLessonBytes);
  const std::string before = std::exchange(m_text, text ? *text : std::string());
  if (m_text != before)
    emit changed(text);
}

} // namespace halfspace
