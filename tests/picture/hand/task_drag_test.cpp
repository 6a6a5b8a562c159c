// Every task of every lesson can be reached by the drag that it asks for: by the mathematics of a mouse drag
// over pixels, in the view that the lesson begins with, at the usual snapping grid.
#include "lessons/lesson/condition.h"
#include "lessons/lesson/task_progress.h"
#include "lessons/lesson/task_targets.h"
#include "tests/lessons/scenes.h"
#include "widgets/picture/hand/handle_drag.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halfspace {
namespace {

using namespace test;

/// As much of a window of 1280×800 as the scene has.
constexpr PixelSize viewSize{840, 730};
const Rational usualStep = 1;

/// A task and the handles that its words name, each of which shall do it.
struct Asked {
  std::string lesson;
  std::string when;
  std::vector<std::string> handles;
};

const std::vector<Asked> &tableOfTasks() {
  static const std::vector<Asked> table{
      {"plane-implicit", "case = plane and coefficients.0 = 0 and coefficients.1 = 0", {"E.n"}},
      {"plane-implicit", "origin_distance = 0", {"E.offset"}},
      {"plane-implicit", "origin_distance > 0", {"E.offset", "E.P0"}},
      {"signed-distance", "side = negative", {"Q"}},
      {"signed-distance", "side = on", {"Q"}},
      {"signed-distance", "signed_distance = 5", {"Q"}},
      {"signed-distance", "foot.z = 0 and side != on", {"Q"}},
      {"ray-plane-dot", "case = hit and t > 0", {"L.r"}},
      {"ray-plane-dot", "t = 1", {"L.r", "L.Q"}},
      {"ray-plane-dot", "t < 0", {"L.r", "L.Q"}},
      {"ray-plane-dot", "case = parallel", {"L.r"}},
      {"ray-plane-dot", "case = in-plane", {"L.Q"}},
      {"ray-triangle-perp", "case = miss", {"L.Q", "L.r"}},
      {"ray-triangle-perp", "case = hit and location = edge", {"L.Q", "L.r"}},
      {"ray-triangle-perp", "case = hit and location = vertex", {"L.Q", "L.r"}},
      {"ray-triangle-perp", "case = collinear", {"T.P0", "T.P1", "T.P2"}},
      {"ray-triangle-perp", "case = hit", {"T.P0"}},
      {"plane-plane", "case = parallel", {"E.n", "F.n"}},
      {"plane-plane", "case = coincident", {"E.offset", "E.P0"}},
      {"plane-plane", "case = line and cos_angle = 0", {"E.n", "F.n"}},
      {"point-line", "t = 0", {"Q"}},
      {"point-line", "t < 0", {"Q"}},
      {"point-line", "case = on", {"Q"}},
      {"point-line", "distance = 3", {"Q"}},
  };
  return table;
}

bool operator==(const Condition &a, const Condition &b) {
  return a.value == b.value && a.relation == b.relation && a.against == b.against;
}

const Asked *rowOf(const Lesson &lesson, const Task &task) {
  const auto &table = tableOfTasks();
  const auto row = std::find_if(table.begin(), table.end(), [&](const Asked &asked) {
    const auto conditions = *parseConditions(asked.when);
    return asked.lesson == lesson.id &&
           std::equal(conditions.begin(), conditions.end(), task.conditions.begin(), task.conditions.end(),
                      [](const auto &a, const auto &b) { return a == b; });
  });
  return row == table.end() ? nullptr : &*row;
}

/// A step of a lesson while its tasks are being done.
struct Doing {
  const Lesson &lesson;
  const LessonStep &step;
  std::size_t task;
  Scene scene;
  TaskProgress progress{};

  void observe(const Scene &now, const Evaluation &evaluation) {
    progress.observe(step.tasks, evaluation);
    if (progress.done()[task])
      scene = now;
  }
};

/// Drags a handle all over the view, line by line, coarsely at first, until the task is done.
bool doneByDragging(Doing &doing, const std::string &id, bool vertical) {
  const View view{Camera(doing.lesson.camera), viewSize, 1};
  const Handle dragged = handle(doing.scene, id);
  const auto pressed = view.camera.project(shownPlace(dragged), view.size);
  const auto mode = grabMode(dragged, vertical, view.camera);
  if (!pressed || !mode)
    return false;
  HandleDrag drag(doing.scene, dragged, *mode, glm::dvec2(*pressed),
                  taskTargets(doing.step.tasks, doing.scene, dragged));
  const Scene before = doing.scene;
  Evaluation evaluation = evaluate(before);
  doing.observe(before, evaluation);
  for (const double spacing : {4 * catchDistance, catchDistance})
    for (double y = 0; y < viewSize.height; y += spacing)
      for (double x = 0; x < viewSize.width; x += spacing) {
        const auto move = drag.moveTo({x, y}, usualStep, view);
        if (!move)
          continue;
        Scene now = before;
        *findObject(now, dragged.object) = move->object;
        evaluation = evaluate(now, evaluation);
        doing.observe(now, evaluation);
        if (doing.progress.done()[doing.task])
          return true;
      }
  return false;
}

TEST(TaskDrag, OfEveryTask_IsSaidInTheTable) {
  std::size_t tasks = 0;
  for (const Lesson &lesson : readLessons(LESSON_FOLDER).lessons)
    for (const LessonStep &step : lesson.steps)
      for (const Task &task : step.tasks) {
        ++tasks;
        EXPECT_TRUE(rowOf(lesson, task)) << lesson.id << ": " << task.instruction;
      }
  EXPECT_GT(tasks, 0U);
}

/// A step's tasks one after the other, each with every handle that it names; the first of them leads on.
void doTasksOf(const Lesson &lesson, const LessonStep &step) {
  Scene scene = lesson.scene;
  TaskProgress progress;
  for (std::size_t task = 0; task < step.tasks.size(); ++task) {
    const Asked *asked = rowOf(lesson, step.tasks[task]);
    ASSERT_TRUE(asked) << step.tasks[task].instruction;
    const Doing start{lesson, step, task, scene, progress};
    for (const std::string &id : asked->handles) {
      Doing doing = start;
      EXPECT_TRUE(doneByDragging(doing, id, false) || doneByDragging(doing, id, true))
          << lesson.id << ": " << step.tasks[task].instruction << " with " << id;
      if (id == asked->handles.front()) {
        scene = doing.scene;
        progress = doing.progress;
      }
    }
  }
}

TEST(TaskDrag, OfEveryHandleThatATaskNames_DoesIt) {
  for (const Lesson &lesson : readLessons(LESSON_FOLDER).lessons)
    for (const LessonStep &step : lesson.steps)
      doTasksOf(lesson, step);
}

} // namespace
} // namespace halfspace
