// Where figures are made beside the event loop.
#pragma once

#include "app/figures/figure_maker.h"
#include "app/memory.h"
#include "widgets/latest_job.h"
#include "widgets/typeset/typesetter.h"

#include <functional>
#include <memory>
#include <optional>

namespace halfspace {

/// Gives memory back at the end of its life.
struct MemoryReturner {
  MemoryReturner() = default;
  ~MemoryReturner() { returnFreeMemory(); }
  MemoryReturner(const MemoryReturner &) = delete;
  MemoryReturner &operator=(const MemoryReturner &) = delete;
};

/// What figures are made with; for one thread at a time.
struct FigureStudio {
  MemoryReturner last; ///< a context that has ended leaves a hundred megabytes
  Typesetter typesetter;
  FigureMaker maker{typesetter};
};

/// Does one piece of work at a time, in a thread of its own. Of what is asked for meanwhile only the latest
/// is done: a drawing that has begun cannot be given up, and what comes of it is seen earlier than the next.
class FigureWorkshop {
public:
  /// What is done in the thread; it returns what is to be done with the outcome in the asker's.
  using Work = std::function<LatestJob::Message(FigureStudio &studio)>;

  /// Takes the place of work that has not begun.
  void ask(Work work);
  /// Whether something is being done.
  [[nodiscard]] bool isBusy() const { return m_job.isRunning(); }

private:
  void begin();

  std::unique_ptr<FigureStudio> m_studio; ///< made with the first piece of work
  std::optional<Work> m_next;
  LatestJob m_job; ///< ended before the rest of this
};

} // namespace halfspace
