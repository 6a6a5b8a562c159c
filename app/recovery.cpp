#include "app/recovery.h"

#include "app/session_files.h"
#include "lessons/session_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

namespace halfspace {
namespace {

constexpr int keepDelay = 800; // milliseconds

} // namespace

Recovery::Recovery(QString file) : m_file(std::move(file)) {
  m_timer.setSingleShot(true);
  m_timer.setInterval(keepDelay);
  QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] { write(); });
}

QString Recovery::standardFile() {
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
  return folder.isEmpty() ? QString() : folder + "/unsaved.halfspace";
}

std::optional<Session> Recovery::leftBehind() const {
  if (m_file.isEmpty() || !QFileInfo::exists(m_file))
    return {};
  auto session = readSessionFile(m_file.toStdString());
  if (!session)
    return {};
  return std::move(*session);
}

void Recovery::keep(const Session &session) {
  m_session = session;
  if (!m_timer.isActive())
    m_timer.start();
}

void Recovery::keepNow(const Session &session) {
  m_timer.stop();
  m_session = session;
  write();
}

void Recovery::forget() {
  m_timer.stop();
  if (!m_file.isEmpty())
    QFile::remove(m_file);
}

void Recovery::write() {
  if (m_file.isEmpty())
    return;
  QDir().mkpath(QFileInfo(m_file).path());
  // A failure is silent: the user saves on purpose elsewhere, and is told there.
  static_cast<void>(writeSessionFile(m_session, m_file));
}

} // namespace halfspace
