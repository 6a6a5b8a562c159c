// For how long the event loop stands still.
#pragma once

#include "tests/bench/durations.h"

#include <QObject>
#include <QTimer>

#include <algorithm>

namespace halfspace::bench {

/// The longest time between two turns of the event loop.
class Heartbeat {
public:
  Heartbeat() {
    QObject::connect(&m_timer, &QTimer::timeout, [this] { beat(); });
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.start(1);
  }
  [[nodiscard]] double longestPause() const { return m_longest; }

private:
  void beat() {
    m_longest = std::max(m_longest, millisecondsSince(m_last));
    m_last = Clock::now();
  }

  QTimer m_timer;
  Clock::time_point m_last = Clock::now();
  double m_longest = 0;
};

} // namespace halfspace::bench
