// How far a learner has come with the tasks of a step.
#pragma once

#include "lessons/lesson/lesson.h"

#include <optional>
#include <vector>

namespace halfspace {

/// `Open`: the next one; those behind it are `Waiting`. `HoldsAlready`: what the next one asks for is so
/// without the learner's doing.
enum class TaskState { Open, HoldsAlready, Waiting, Done };

/// Tasks count in their order, and only when the learner brings them about: what is true on arrival is done
/// once it has been untrue and is true again. Where the scene begins anew, so do the tasks; what was done
/// before stays done for the lesson.
class TaskProgress {
public:
  TaskProgress() = default;
  /// Goes on where so much was done already.
  explicit TaskProgress(std::vector<bool> done) : m_everDone(done), m_done(std::move(done)) {}

  /// The learner comes to the step, for the first time or again.
  void arrive();
  /// The scene has other numbers, or begins anew: all tasks are open again.
  void beginAnew();
  /// Takes note of what the scene has come to.
  void observe(const std::vector<Task> &tasks, const Evaluation &evaluation);

  /// The tasks in their order.
  [[nodiscard]] std::vector<TaskState> states() const;
  /// Which of them have ever been done.
  [[nodiscard]] const std::vector<bool> &done() const { return m_everDone; }
  bool operator==(const TaskProgress &) const = default;

private:
  std::vector<bool> m_everDone;
  std::vector<bool> m_done;    ///< with the numbers that there are
  std::vector<bool> m_wasOpen; ///< seen untrue since the arrival
  std::optional<std::size_t> m_holdsAlready;
};

} // namespace halfspace
