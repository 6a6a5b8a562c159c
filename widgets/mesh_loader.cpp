#include "widgets/mesh_loader.h"

#include "lessons/words.h"
#include "widgets/mesh_files/mesh_wire.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QProcess>

#include <atomic>
#include <new>
#include <utility>

namespace halfspace {
namespace {

/// It is looked at least so often whether loading was cancelled.
constexpr int millisecondsBetweenLooks = 20;
/// It is told at most so often how far loading is.
constexpr qint64 millisecondsBetweenNews = 40;
constexpr qint64 pieceSize = 1 << 20;

/// Which part of the whole the file's reading, its way here, and making it ready are; by measurement.
constexpr double untilRead = 0.25;
constexpr double untilArrived = 0.3;

QString inQt(const std::string &text) { return QString::fromStdString(text); }

/// Passes on a part of all news, so that they do not pile up before whoever hears them.
class News {
public:
  using Tell = std::function<void(double part, const QString &what)>;

  explicit News(Tell tell) : m_tell(std::move(tell)) {}

  void operator()(double part, const QString &what) {
    if (what == m_what && m_sinceTold.isValid() && m_sinceTold.elapsed() < millisecondsBetweenNews)
      return;
    m_what = what;
    m_sinceTold.start();
    m_tell(part, what);
  }

private:
  Tell m_tell;
  QString m_what;
  QElapsedTimer m_sinceTold;
};

void tellReading(const MeshDecoder &decoder, News &news) {
  const QString what = inQt(words("Reading the file"));
  if (decoder.arrived() > 0)
    news(untilRead + (untilArrived - untilRead) * decoder.arrived(), what);
  else
    news(decoder.part() ? untilRead * *decoder.part() : -1, what);
}

/// The program that reads, what it is given, and how long it may take.
struct Reading {
  QString program;
  QString file;
  std::chrono::milliseconds longest;
};

/// What the process of its own reads, or why it could not.
Result<RawMesh> readInProcess(const Reading &reading, const std::atomic<bool> &cancelled, News &news) {
  QElapsedTimer taken;
  taken.start();
  QProcess process;
  process.setStandardInputFile(QProcess::nullDevice());
  process.setStandardErrorFile(QProcess::nullDevice());
  process.start(reading.program, {readMeshCommand, QFileInfo(reading.file).absoluteFilePath()},
                QIODevice::ReadOnly);
  if (!process.waitForStarted())
    return Problem{words("The program that reads meshes cannot be started."), "", 0, ""};
  MeshDecoder decoder;
  tellReading(decoder, news);
  const auto isTooLate = [&] { return taken.hasExpired(reading.longest.count()); };
  while (!cancelled && !decoder.problem() && !decoder.isDone() && !isTooLate()) {
    const bool hasBytes = process.bytesAvailable() > 0 || process.waitForReadyRead(millisecondsBetweenLooks);
    if (hasBytes || process.bytesAvailable() > 0) {
      const QByteArray piece = process.read(pieceSize);
      decoder.feed({piece.constData(), static_cast<std::size_t>(piece.size())});
      tellReading(decoder, news);
    } else if (process.state() == QProcess::NotRunning) {
      decoder.finish();
    }
  }
  process.kill();
  process.waitForFinished();
  if (decoder.isDone())
    return decoder.take();
  if (decoder.problem() || cancelled)
    return decoder.problem().value_or(Problem{});
  return Problem{words("Reading the file takes too long."), "", 0, ""};
}

/// What comes of a file, or why nothing does; once cancelled, a problem that is for nobody.
Result<LoadedMesh> loadMesh(const Reading &reading, const std::atomic<bool> &cancelled, News &news) {
  const QFileInfo names(reading.file);
  const auto refuse = [&names](Problem problem) {
    problem.file = names.fileName().toStdString();
    return problem;
  };
  try {
    auto raw = readInProcess(reading, cancelled, news);
    if (!raw || cancelled)
      return refuse(raw ? Problem{} : raw.problem());
    const QString what = inQt(words("Making the mesh ready"));
    auto loaded = makeShape(std::move(*raw), names.completeBaseName().toStdString(), cancelled,
                            [&](std::optional<double> part) {
                              news(untilArrived + (1 - untilArrived) * part.value_or(0), what);
                            });
    return loaded ? loaded : refuse(loaded.problem());
  } catch (const std::bad_alloc &) {
    return refuse({words("There is not enough memory for this mesh."), "", 0, ""});
  }
}

} // namespace

MeshLoader::MeshLoader(QObject *parent)
    : QObject(parent), m_program(QCoreApplication::applicationFilePath()) {
  qRegisterMetaType<LoadedMesh>();
}

void MeshLoader::start(const QString &file) {
  cancel();
  m_job.start([this, reading = Reading{m_program, file, m_longestReading}](
                  const std::atomic<bool> &cancelled, const LatestJob::Post &post) -> LatestJob::Message {
    News news(
        [&](double part, const QString &what) { post([this, part, what] { emit progressed(part, what); }); });
    return [this, result = loadMesh(reading, cancelled, news)] { end(result); };
  });
}

void MeshLoader::cancel() {
  if (m_job.cancel())
    emit cancelled();
}

void MeshLoader::end(const Result<LoadedMesh> &result) {
  if (result)
    emit loaded(*result);
  else
    emit failed(inQt(result.problem().text()));
}

} // namespace halfspace
