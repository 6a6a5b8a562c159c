// The thread on which MathJax runs.
#pragma once

#include "widgets/typeset/math_picture.h"

#include <QStringList>

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

class QJSEngine;

namespace halfspace {

/// Makes pictures one after the other. All functions may be called from any thread.
class TypesetWorker {
public:
  struct Made {
    QString latex;
    std::shared_ptr<const MathPicture> formula;
  };

  /// Longer sources are refused.
  static constexpr int longestLatex = 4000;

  /// Starts the thread.
  TypesetWorker();
  /// Ends the formula in work and the thread.
  ~TypesetWorker();
  TypesetWorker(const TypesetWorker &) = delete;
  TypesetWorker &operator=(const TypesetWorker &) = delete;

  /// Replaces the orders that wait.
  void setQueue(const QStringList &orders);
  /// The pictures made since the last call.
  [[nodiscard]] std::vector<Made> takeMade();
  /// Waits until a picture is there, and at most so long.
  void waitForMade(std::chrono::milliseconds time);
  /// Ends the formula in work, with an error, if it has taken longer than this.
  void giveUpAfter(std::chrono::milliseconds patience);

private:
  using Clock = std::chrono::steady_clock;

  void run();
  /// Waits for work; false at the end.
  bool takeNext();

  std::mutex m_mutex; ///< guards all below
  std::condition_variable m_work;
  std::condition_variable m_result;
  QStringList m_queue;
  std::optional<QString> m_current; ///< what is in work
  Clock::time_point m_started;
  std::vector<Made> m_made;
  QJSEngine *m_engine = nullptr; ///< the thread's, while it lives
  bool m_ending = false;
  std::thread m_thread; ///< last: it uses all above
};

} // namespace halfspace
