// The thread on which MathJax runs.
#pragma once

#include "widgets/typeset/math_picture.h"
#include "widgets/typeset/typeset_order.h"

#include <QList>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

class QJSEngine;

namespace halfspace {

/// Makes pictures one after the other, and paints labels. All functions may be called from any thread.
class TypesetWorker {
public:
  struct Made {
    TypesetOrder order;
    std::shared_ptr<const MathPicture> formula; ///< null where a label was ordered
    std::shared_ptr<const LabelPicture> label;  ///< null where a formula was ordered
  };

  /// Longer sources are refused.
  static constexpr int longestLatex = 4000;

  /// Starts the thread. `arrived` is called on it when the first picture after a `takeMade` is there.
  explicit TypesetWorker(std::function<void()> arrived);
  /// Ends the formula in work and the thread.
  ~TypesetWorker();
  TypesetWorker(const TypesetWorker &) = delete;
  TypesetWorker &operator=(const TypesetWorker &) = delete;

  /// Replaces the orders that wait.
  void setQueue(const QList<TypesetOrder> &orders);
  /// The pictures made since the last call.
  [[nodiscard]] std::vector<Made> takeMade();
  /// Waits until a picture is there, and at most so long.
  void waitForMade(std::chrono::milliseconds time);
  /// Ends the formula in work, with an error, if it has taken longer than this.
  void giveUpAfter(std::chrono::milliseconds patience);
  [[nodiscard]] bool isIdle() const;

private:
  using Clock = std::chrono::steady_clock;

  void run();
  /// Waits for work; false at the end.
  bool takeNext();

  std::function<void()> m_arrived;
  mutable std::mutex m_mutex; ///< guards all below
  std::condition_variable m_work;
  std::condition_variable m_result;
  QList<TypesetOrder> m_queue;
  std::optional<TypesetOrder> m_current; ///< what is in work
  Clock::time_point m_started;
  std::vector<Made> m_made;
  QJSEngine *m_engine = nullptr; ///< the thread's, while it lives
  bool m_ending = false;
  std::thread m_thread; ///< last: it uses all above
};

} // namespace halfspace
