#include "widgets/latest_job.h"

#include <QThread>

#include <utility>

namespace halfspace {

struct LatestJob::Job {
  std::atomic<bool> cancelled{false};
  std::unique_ptr<QThread> thread;
};

LatestJob::LatestJob() = default;

LatestJob::~LatestJob() {
  for (const auto &job : m_jobs)
    job->cancelled = true;
  for (const auto &job : m_jobs)
    job->thread->wait();
}

void LatestJob::start(const Work &work) {
  cancel();
  m_jobs.push_back(std::make_unique<Job>());
  m_current = m_jobs.back().get();
  m_current->thread.reset(QThread::create([this, &job = *m_current, work] { run(job, work); }));
  m_current->thread->start();
}

bool LatestJob::cancel() {
  if (m_current == nullptr)
    return false;
  std::exchange(m_current, nullptr)->cancelled = true;
  return true;
}

/// In the job's thread.
void LatestJob::run(Job &job, const Work &work) {
  const auto post = [&](const Message &message) {
    const auto unlessCancelled = [this, &job, message] {
      if (&job == m_current)
        message();
    };
    QMetaObject::invokeMethod(&m_owner, unlessCancelled, Qt::QueuedConnection);
  };
  const Message last = work(job.cancelled, post);
  QMetaObject::invokeMethod(
      &m_owner, [this, &job, last] { end(job, last); }, Qt::QueuedConnection);
}

void LatestJob::end(const Job &job, const Message &last) {
  const bool isCurrent = &job == m_current;
  job.thread->wait();
  std::erase_if(m_jobs, [&](const auto &one) { return one.get() == &job; });
  if (!isCurrent)
    return;
  m_current = nullptr;
  last();
}

} // namespace halfspace
