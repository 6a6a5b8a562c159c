#include "app/export/figure_workshop.h"

#include <utility>

namespace halfspace {

void FigureWorkshop::ask(Work work) {
  m_next = std::move(work);
  if (!isBusy())
    begin();
}

void FigureWorkshop::begin() {
  m_job.start([this, work = *std::exchange(m_next, std::nullopt)](const std::atomic<bool> &,
                                                                  const LatestJob::Post &) {
    if (!m_studio)
      m_studio = std::make_unique<FigureStudio>();
    return LatestJob::Message([this, tell = work(*m_studio)] {
      if (m_next)
        begin();
      tell();
    });
  });
}

} // namespace halfspace
