// A thread that works while somebody waits for it.
#pragma once

#include <condition_variable>
#include <functional>
#include <future>
#include <mutex>
#include <thread>

namespace halfspace {

/// Does one job after the other, all in one thread that is not the caller's: for what belongs to the thread
/// that made it, as an OpenGL context does.
class JobThread {
public:
  JobThread();
  ~JobThread();
  JobThread(const JobThread &) = delete;
  JobThread &operator=(const JobThread &) = delete;

  /// Returns when the job is done; what it throws is thrown here. To be called by one thread at a time.
  void run(const std::function<void()> &job);

private:
  void work();

  std::mutex m_mutex;
  std::condition_variable m_given;
  std::packaged_task<void()> *m_job = nullptr; ///< waits to be begun
  bool m_isEnding = false;
  std::thread m_thread; // the last: it uses the others
};

} // namespace halfspace
