#include "app/work/recovery.h"

#include "app/folders.h"
#include "lessons/files/descriptor.h"
#include "lessons/files/read_file.h"
#include "lessons/files/write_file.h"
#include "lessons/scene/file/session_file.h"
#include "lessons/words.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLockFile>
#include <QStandardPaths>
#include <QUuid>

#include <sys/file.h>

namespace halfspace {
namespace {

/// As many sessions as there may be lessons that were left.
constexpr std::size_t maxFileBytes = 4 * maxSessionBytes;

QString newPath(const QString &folder) {
  return folder + "/" + QUuid::createUuid().toString(QUuid::WithoutBraces) + ".json";
}

/// The file beside a leftover that is there while it is being opened.
QString openingMark(const QString &path) { return path + ".opening"; }

/// The lock of a file, not held yet.
std::unique_ptr<QLockFile> lockOf(const QString &path) {
  auto lock = std::make_unique<QLockFile>(path + ".lock");
  lock->setStaleLockTime(0); // a lock is stale when its program is gone, not when it is old
  return lock;
}

/// Held by one program at a time, as long as it lives: who looks for leftovers takes their locks for a
/// moment, and another would take that for a sign of life. Where there is no such folder, or it cannot be
/// held, nobody waits.
class FolderTurn {
public:
  explicit FolderTurn(const QString &folder)
      : m_folder(::open(QFile::encodeName(folder).constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (m_folder.isOpen())
      static_cast<void>(::flock(m_folder.get(), LOCK_EX)); // until it is closed
  }

private:
  Descriptor m_folder;
};

/// Whether a living program holds the lock of a file. (Where no lock can be made, as in a read-only home,
/// nobody has made one.)
bool isHeld(const QString &path) {
  const auto lock = lockOf(path);
  return !lock->tryLock(0) && lock->error() == QLockFile::LockFailedError;
}

/// Why no lock can be made for a file that nobody else knows.
std::string whyNotLocked(const QLockFile &lock) {
  return lock.error() == QLockFile::PermissionError ? words("you may not write there")
                                                    : words("there may be no room left on the disk");
}

QString textOf(const Session &session) { return QString::fromStdString(writeSession(session)); }

QJsonValue toJson(const KnownFile *file) {
  if (!file)
    return {};
  return QJsonObject{{"path", file->path},
                     {"text", QString::fromStdString(file->text)},
                     {"lesson", QString::fromStdString(file->lesson)}};
}

std::shared_ptr<const KnownFile> fileFrom(const QJsonValue &json) {
  if (!json["path"].isString())
    return {};
  return std::make_shared<KnownFile>(KnownFile{json["path"].toString(), json["text"].toString().toStdString(),
                                               json["lesson"].toString().toStdString()});
}

std::string toText(const UnsavedWork &work) {
  QJsonArray left;
  for (const auto &[lesson, session] : work.left)
    left.append(textOf(session));
  return QJsonDocument(QJsonObject{{"session", textOf(work.session)},
                                   {"left", left},
                                   {"file", toJson(work.file.get())},
                                   {"lessons", work.lessons ? toJson(*work.lessons) : QJsonValue()}})
      .toJson()
      .toStdString();
}

std::optional<UnsavedWork> readWork(const QString &path) {
  const auto text = readFile(path.toStdString(), maxFileBytes);
  if (!text)
    return {};
  const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(*text)).object();
  const auto read = [&](const QJsonValue &session) {
    return readSession(session.toString().toStdString(), path.toStdString());
  };
  auto session = read(json["session"]);
  if (!session)
    return {};
  UnsavedWork work{std::move(*session),
                   {},
                   fileFrom(json["file"]),
                   std::make_shared<const LessonWorks>(lessonWorksFrom(json["lessons"]))};
  for (const QJsonValue &other : json["left"].toArray())
    if (auto left = read(other))
      work.left[left->lesson] = *left;
  return work;
}

/// Nobody is still writing a file that was begun so long ago, in seconds.
constexpr int longSinceBegun = 600;

/// Removes what programs that were killed while they wrote have left of it.
void removeUnfinished(const QString &folder) {
  const QDateTime then = QDateTime::currentDateTime().addSecs(-longSinceBegun);
  for (const QFileInfo &info : QDir(folder).entryInfoList(QDir::Files | QDir::Hidden))
    if (isUnfinishedFile(info.fileName().toStdString()) && info.lastModified() < then)
      QFile::remove(info.filePath());
}

} // namespace

Recovery::Recovery(QString folder) : m_folder(std::move(folder)), m_path(newPath(m_folder)) {
  if (!m_folder.isEmpty())
    removeUnfinished(m_folder);
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
  const FolderTurn turn(m_folder);
  const auto files = QDir(m_folder).entryInfoList({"*.json"}, QDir::Files, QDir::Time);
  for (const QFileInfo &info : files) {
    const QString path = info.filePath();
    if (path == m_path || isHeld(path))
      continue;
    if (auto work = readWork(path))
      found.push_back({path, info.lastModified(), std::move(*work), QFile::exists(openingMark(path))});
  }
  return found;
}

std::optional<UnsavedWork> Recovery::adopt(const QString &path) {
  const FolderTurn turn(m_folder);
  auto lock = lockOf(path);
  const bool locked = lock->tryLock(0);
  if (!locked && lock->error() == QLockFile::LockFailedError)
    return {};
  auto work = readWork(path);
  if (!work)
    return {};
  const std::scoped_lock held(m_mutex);
  removeMark(); // of what was here before
  // Without the mark it is opened all the same: only the next start would not know.
  static_cast<void>(writeFile(openingMark(path).toStdString(), "", Readers::OwnerOnly));
  m_path = path;
  m_lock = locked ? std::move(lock) : nullptr; // else keep() tries again, and tells
  return work;
}

void Recovery::removeMark() { QFile::remove(openingMark(m_path)); }

void Recovery::opened() {
  const std::scoped_lock held(m_mutex);
  removeMark();
}

std::optional<Problem> Recovery::keep(const UnsavedWork &work) {
  const std::scoped_lock held(m_mutex);
  return keepLocked(work);
}

void Recovery::prepare(std::optional<UnsavedWork> work) {
  const std::scoped_lock held(m_mutex);
  m_prepared = std::move(work);
}

std::optional<Problem> Recovery::keepPrepared() {
  const std::scoped_lock held(m_mutex);
  return m_prepared ? keepLocked(*m_prepared) : std::nullopt;
}

void Recovery::leave() {
  const std::scoped_lock held(m_mutex);
  removeMark();
  m_prepared.reset();
  m_lock.reset();
}

std::optional<Problem> Recovery::keepLocked(const UnsavedWork &work) {
  if (m_folder.isEmpty())
    return Problem{words("There is no folder for unsaved work on this system."), "", 0, ""};
  if (auto problem = makeFolder(m_folder))
    return problem;
  if (!m_lock) {
    auto lock = lockOf(m_path);
    if (!lock->tryLock(0))
      return Problem{
          words("No file can be made in this folder: {reason}.", {{"reason", whyNotLocked(*lock)}}),
          m_folder.toStdString(), 0, ""};
    m_lock = std::move(lock);
  }
  return writeFile(m_path.toStdString(), toText(work), Readers::OwnerOnly);
}

void Recovery::forget() {
  const std::scoped_lock held(m_mutex);
  m_prepared.reset();
  if (!m_lock)
    return;
  QFile::remove(m_path);
  removeMark();
  m_lock.reset();
}

} // namespace halfspace
