// Work beside the event loop, of which only the latest counts.
#pragma once

#include <QObject>

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

namespace halfspace {

/// Runs one job at a time in a thread of its own. A cancelled one ends beside the next, and nothing more is
/// heard of it.
class LatestJob {
public:
  /// Something to be done in the thread that owns the jobs.
  using Message = std::function<void()>;
  using Post = std::function<void(Message)>;
  /// Done in the thread of its own, until `cancelled`. What it posts is done in the order of posting, and
  /// last, when the job is no longer running, what it returns: all from the owner's event loop.
  using Work = std::function<Message(const std::atomic<bool> &cancelled, const Post &post)>;

  LatestJob();
  LatestJob(const LatestJob &) = delete;
  LatestJob &operator=(const LatestJob &) = delete;
  /// Cancels the job, and waits until it and those cancelled before it have ended.
  ~LatestJob();

  /// What is running is cancelled first.
  void start(const Work &work);
  /// Does not wait for its end; whether there was something to cancel.
  bool cancel();
  [[nodiscard]] bool isRunning() const { return m_current != nullptr; }

private:
  struct Job;

  void run(Job &job, const Work &work);
  void end(const Job &job, const Message &last);

  QObject m_owner;                          ///< stands for the owner's thread
  std::vector<std::unique_ptr<Job>> m_jobs; ///< the current one, and cancelled ones that are ending
  Job *m_current = nullptr;
};

} // namespace halfspace
