#include "app/recovery.h"

#include "lessons/session_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLockFile>
#include <QSaveFile>
#include <QStandardPaths>
#include <QUuid>

namespace halfspace {
namespace {

constexpr int keepDelay = 800; // milliseconds
/// As many sessions as there may be lessons that were left.
constexpr qint64 maxFileBytes = 4 * static_cast<qint64>(maxSessionBytes);

QString newPath(const QString &folder) {
  return folder + "/" + QUuid::createUuid().toString(QUuid::WithoutBraces) + ".json";
}

/// The lock of a file, held; null where a living program holds it.
std::unique_ptr<QLockFile> locked(const QString &path) {
  auto lock = std::make_unique<QLockFile>(path + ".lock");
  lock->setStaleLockTime(0); // a lock is stale when its program is gone, not when it is old
  return lock->tryLock(0) ? std::move(lock) : nullptr;
}

QString textOf(const Session &session) { return QString::fromStdString(writeSession(session)); }

QByteArray toBytes(const UnsavedWork &work) {
  QJsonArray left;
  for (const auto &[lesson, session] : work.left)
    left.append(textOf(session));
  return QJsonDocument(QJsonObject{{"session", textOf(work.session)},
                                   {"left", left},
                                   {"file", work.file},
                                   {"progress", toJson(work.progress)}})
      .toJson();
}

std::optional<UnsavedWork> readWork(const QString &path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly) || file.size() > maxFileBytes)
    return {};
  const QJsonObject json = QJsonDocument::fromJson(file.readAll()).object();
  const auto read = [&](const QJsonValue &text) {
    return readSession(text.toString().toStdString(), path.toStdString());
  };
  auto session = read(json["session"]);
  if (!session)
    return {};
  UnsavedWork work{
      std::move(*session), {}, json["file"].toString(), progressFrom(json["progress"].toArray())};
  for (const QJsonValue &text : json["left"].toArray())
    if (auto left = read(text))
      work.left[left->lesson] = *left;
  return work;
}

} // namespace

Recovery::Recovery(QString folder) : m_folder(std::move(folder)), m_path(newPath(m_folder)) {
  m_timer.setSingleShot(true);
  m_timer.setInterval(keepDelay);
  QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] { write(); });
}

Recovery::~Recovery() = default;

QString Recovery::standardFolder() {
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
  return folder.isEmpty() ? QString() : folder + "/unsaved";
}

std::vector<Recovery::Leftover> Recovery::leftovers() const {
  std::vector<Leftover> found;
  if (m_folder.isEmpty())
    return found;
  const auto files = QDir(m_folder).entryInfoList({"*.json"}, QDir::Files, QDir::Time);
  for (const QFileInfo &info : files) {
    const QString path = info.filePath();
    if (path == m_path || !locked(path))
      continue;
    if (auto work = readWork(path))
      found.push_back({path, info.lastModified(), std::move(*work)});
  }
  return found;
}

bool Recovery::adopt(const QString &path) {
  auto lock = locked(path);
  if (!lock)
    return false;
  if (m_timer.isActive()) {
    m_timer.stop();
    write();
  }
  m_path = path;
  m_lock = std::move(lock);
  return true;
}

void Recovery::keep(UnsavedWork work) {
  m_work = std::move(work);
  if (!m_timer.isActive())
    m_timer.start();
}

void Recovery::keepNow(UnsavedWork work) {
  m_timer.stop();
  m_work = std::move(work);
  write();
}

void Recovery::forget() {
  m_timer.stop();
  if (!m_lock)
    return;
  QFile::remove(m_path);
  m_lock.reset();
}

void Recovery::write() {
  if (m_folder.isEmpty())
    return;
  QDir().mkpath(m_folder);
  if (!m_lock)
    m_lock = locked(m_path);
  // A failure is silent: the user saves on purpose elsewhere, and is told there.
  QSaveFile out(m_path);
  if (m_lock && out.open(QIODevice::WriteOnly) && out.write(toBytes(m_work)) >= 0)
    out.commit();
}

} // namespace halfspace
