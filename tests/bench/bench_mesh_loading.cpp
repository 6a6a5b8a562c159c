// Meshes of 10^5 to 5·10^6 triangles loaded: how long reading and making ready take, for how long the event
// loop stands still meanwhile, and how much memory the two processes take at most.
#include "tests/bench/bumpy_ball.h"
#include "tests/bench/durations.h"
#include "tests/bench/heartbeat.h"
#include "widgets/mesh_loader.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QFile>
#include <QTemporaryDir>

#include <cstdio>
#include <sys/resource.h>

namespace halfspace::bench {
namespace {

constexpr double longestPauseGoal = 16; // a frame

double peakMegabytes(__rusage_who who) {
  rusage usage{};
  ::getrusage(who, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

void measure(std::size_t triangles, const QTemporaryDir &folder) {
  const QString path = folder.filePath("ball.stl");
  {
    const std::string stl = bumpyBall(triangles);
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(stl.data(), static_cast<qint64>(stl.size())) < 0)
      return;
  }
  MeshLoader loader;
  loader.setProgram(QCoreApplication::applicationDirPath() + "/halfspace");
  QEventLoop loop;
  Clock::time_point ready;
  QString before;
  QObject::connect(&loader, &MeshLoader::progressed, [&](double, const QString &what) {
    if (what != std::exchange(before, what))
      ready = Clock::now(); // so far that of the last step's begin
  });
  QObject::connect(&loader, &MeshLoader::failed, [&](const QString &why) {
    std::printf("%s\n", qPrintable(why));
    loop.quit();
  });
  LoadedMesh loaded;
  QObject::connect(&loader, &MeshLoader::loaded, [&](const LoadedMesh &mesh) {
    loaded = mesh;
    loop.quit();
  });
  const Heartbeat heartbeat;
  const auto start = Clock::now();
  loader.start(path);
  loop.exec();
  const double all = millisecondsSince(start);
  const double read = milliseconds(ready - start);
  std::printf("\n%zu triangles, %zu corners: read in %.0f ms, made ready in %.0f ms\n", loaded.triangles,
              loaded.shape ? loaded.shape->mesh()->corners.size() : 0, read, all - read);
  std::printf("  memory at most, in MiB: here %.0f, the process that reads %.0f\n",
              peakMegabytes(RUSAGE_SELF), peakMegabytes(RUSAGE_CHILDREN));
  std::printf("event loop's longest pause: %.1f ms (goal %.0f) %s\n", heartbeat.longestPause(),
              longestPauseGoal, heartbeat.longestPause() <= longestPauseGoal ? "met" : "missed");
  std::fflush(stdout);
}

} // namespace
} // namespace halfspace::bench

int main(int argc, char **argv) {
  const QCoreApplication application(argc, argv);
  const QTemporaryDir folder;
  for (const std::size_t triangles : {100'000U, 1'000'000U, 5'000'000U})
    halfspace::bench::measure(triangles, folder);
}
