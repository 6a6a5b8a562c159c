#include "lessons/lesson/task_progress.h"

namespace halfspace {

void TaskProgress::arrive() { m_wasOpen.clear(); }

void TaskProgress::beginAnew() {
  arrive();
  m_done.clear();
}

void TaskProgress::observe(const std::vector<Task> &tasks, const Evaluation &evaluation) {
  m_everDone.resize(tasks.size(), false);
  m_done.resize(tasks.size(), false);
  m_wasOpen.resize(tasks.size(), false);
  m_holdsAlready.reset();
  bool isNext = true;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const bool holds = isDone(tasks[i], evaluation);
    m_wasOpen[i] = m_wasOpen[i] || !holds;
    if (isNext && holds && m_wasOpen[i])
      m_everDone[i] = m_done[i] = true;
    if (isNext && holds && !m_done[i])
      m_holdsAlready = i;
    isNext = isNext && m_done[i];
  }
}

std::vector<TaskState> TaskProgress::states() const {
  std::vector<TaskState> states;
  bool isNext = true;
  for (const bool done : m_done) {
    states.push_back(done ? TaskState::Done : isNext ? TaskState::Open : TaskState::Waiting);
    isNext = isNext && done;
  }
  if (m_holdsAlready)
    states[*m_holdsAlready] = TaskState::HoldsAlready;
  return states;
}

} // namespace halfspace
