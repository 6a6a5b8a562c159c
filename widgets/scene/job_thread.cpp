#include "widgets/scene/job_thread.h"

#include <utility>

namespace halfspace {

JobThread::JobThread() : m_thread([this] { work(); }) {}

JobThread::~JobThread() {
  {
    const std::lock_guard lock(m_mutex);
    m_isEnding = true;
  }
  m_given.notify_one();
  m_thread.join();
}

void JobThread::run(const std::function<void()> &job) {
  std::packaged_task<void()> task(job);
  std::future<void> done = task.get_future();
  {
    const std::lock_guard lock(m_mutex);
    m_job = &task;
  }
  m_given.notify_one();
  done.get();
}

void JobThread::work() {
  std::unique_lock lock(m_mutex);
  for (;;) {
    m_given.wait(lock, [this] { return m_job || m_isEnding; });
    if (!m_job)
      return;
    std::packaged_task<void()> task = std::move(*std::exchange(m_job, nullptr));
    lock.unlock();
    task();
    lock.lock();
  }
}

} // namespace halfspace
