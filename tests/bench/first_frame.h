// What the two programs that start and say when have in common.
#pragma once

#include <QCoreApplication>
#include <QOpenGLWidget>
#include <QTimer>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <utility>

namespace halfspace::bench {

/// How long after the first frame the memory is measured, in milliseconds.
inline constexpr int settlingTime = 2000;

/// What of the program is in memory, in MiB.
inline double residentMemory() {
  std::ifstream status("/proc/self/status");
  std::string line;
  while (std::getline(status, line))
    if (line.rfind("VmRSS:", 0) == 0)
      return std::atof(line.c_str() + 6) / 1024;
  return 0;
}

/// Once the window with the view in it, painted whole, is handed to the screen: prints the milliseconds since
/// the program was started, given in nanoseconds of the monotonic clock, and, later, the memory in MiB; then
/// the program ends.
inline void reportFirstFrame(const QOpenGLWidget &view, const char *started) {
  const std::chrono::nanoseconds start(std::atoll(started));
  QObject::connect(&view, &QOpenGLWidget::frameSwapped, qApp, [start, isFirst = true]() mutable {
    if (!std::exchange(isFirst, false))
      return;
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    std::printf("%.1f ", std::chrono::duration<double, std::milli>(now - start).count());
    QTimer::singleShot(settlingTime, qApp, [] {
      std::printf("%.1f\n", residentMemory());
      std::fflush(stdout);
      std::_Exit(0);
    });
  });
}

} // namespace halfspace::bench
