// What the two programs that start and say when have in common.
#pragma once

#include <QCoreApplication>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QTimer>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

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

/// To be called when the first frame is drawn, with the time at which the program was started in nanoseconds
/// of the monotonic clock. Prints the milliseconds since then and, later, the memory in MiB; then the program
/// ends.
inline void reportFirstFrame(const char *started) {
  QOpenGLContext::currentContext()->functions()->glFinish();
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  const std::chrono::nanoseconds since = now - std::chrono::nanoseconds(std::atoll(started));
  std::printf("%.1f ", std::chrono::duration<double, std::milli>(since).count());
  QTimer::singleShot(settlingTime, qApp, [] {
    std::printf("%.1f\n", residentMemory());
    std::fflush(stdout);
    std::_Exit(0);
  });
}

} // namespace halfspace::bench
