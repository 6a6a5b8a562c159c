// Every task of every lesson can be reached by the drag that it asks for: by the mathematics of a mouse drag
// over pixels, in the view that the lesson begins with, at the usual snapping grid.
#include "lessons/lesson/condition.h"
#include "lessons/lesson/task_progress.h"
#include "lessons/lesson/task_targets.h"
#include "tests/effort.h"
#include "tests/lessons/scenes.h"
#include "widgets/picture/camera_views.h"
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
      {"plane-implicit", "side = negative", {"P"}},
      {"plane-implicit", "side = on", {"P"}},
      {"plane-implicit", "case = plane and coefficients.0 = 0 and coefficients.1 = 0", {"E.n"}},
      {"plane-implicit", "origin_distance = 0", {"E.offset"}},
      {"plane-implicit", "coefficients.3 > 0", {"E.offset", "E.P0"}},
      {"plane-implicit", "coefficients.0 = 0 and coefficients.1 = 0 and coefficients.2 = 1", {"E.n"}},
      {"half-spaces", "side_B = positive", {"B"}},
      {"half-spaces", "side_C = negative", {"C"}},
      {"half-spaces", "side_A = on", {"E.offset"}},
      {"half-spaces", "case = one-side and on = 0", {"E.offset"}},
      {"half-spaces", "coefficients.2 < 0", {"E.n"}},
      {"plane-parametric", "s = 1/2 and t = 1/2", {"P"}},
      {"plane-parametric", "s < 0", {"P"}},
      {"plane-parametric", "s = 0 and t = 1", {"P"}},
      {"plane-parametric", "s = 1/2 and t = 0", {"P"}},
      {"plane-parametric", "s = 0 and location = outside", {"P"}},
      {"plane-parametric", "barycentric.0 = 0 and location = edge", {"P"}},
      {"plane-parametric", "in_parallelogram = yes and location = outside", {"P"}},
      {"plane-parametric", "s = 1 and t = 1", {"P"}},
      {"plane-parametric", "case = collinear", {"T.P0", "T.P1", "T.P2"}},
      {"line-ray-segment", "t = 2", {"P"}},
      {"line-ray-segment", "t = -1", {"P"}},
      {"line-ray-segment", "part = beyond", {"P"}},
      {"line-ray-segment", "part = before", {"P"}},
      {"line-ray-segment", "t = 1/2", {"P"}},
      {"line-ray-segment", "t = 3/4", {"P"}},
      {"line-ray-segment", "on = yes", {"Q"}},
      {"line-ray-segment", "case = segment", {"Q"}},
      {"line-ray-segment", "case = before", {"Q"}},
      {"line-ray-segment", "direction.0 = 0 and case != zero-direction", {"g.v"}},
      {"line-ray-segment", "case = zero-direction", {"g.v"}},
      {"dot-product-projection", "dot = 0 and case = right", {"w.v", "v.v"}},
      {"dot-product-projection", "sign = negative", {"w.v", "v.v"}},
      {"dot-product-projection", "length_v = 1", {"v.v"}},
      {"dot-product-projection", "length_v > 1", {"v.v"}},
      {"dot-product-projection", "case = same-direction", {"w.v"}},
      {"dot-product-projection", "unit_v.0 = 1", {"v.v"}},
      {"determinant", "height = 2", {"w.v"}},
      {"determinant", "det = 75", {"w.v"}},
      {"determinant", "orientation = left-handed", {"w.v"}},
      {"determinant", "case = flat", {"w.v"}},
      {"determinant", "case = parallel and base_area = 0", {"v.v"}},
      {"determinant", "tetrahedron = 4", {"u.v", "v.v", "w.v"}},
      {"determinant",
       "double_cross.0 = 0 and double_cross.1 = 0 and double_cross.2 = 0 and det != 0",
       {"u.v"}},
      {"determinant", "tetrahedron = 5 and orientation = left-handed", {"w.v"}},
      {"signed-distance", "side = negative", {"Q"}},
      {"signed-distance", "side = on", {"Q"}},
      {"signed-distance", "steps = 1", {"Q"}},
      {"signed-distance", "signed_distance = 5", {"Q"}},
      {"signed-distance", "cos_angle = 0", {"Q"}},
      {"signed-distance", "cos_angle < 0", {"Q"}},
      {"signed-distance", "foot.z = 0 and side != on", {"Q"}},
      {"ray-plane-substitution", "plane0.case = hit and plane0.t > 0", {"L.r"}},
      {"ray-plane-substitution", "first = none", {"L.r"}},
      {"ray-plane-substitution", "first = plane1", {"L.r"}},
      {"ray-plane-substitution", "plane1.case = parallel", {"L.r"}},
      {"ray-plane-substitution", "plane1.case = in-plane", {"L.Q"}},
      {"ray-plane-substitution", "plane1.t = 0", {"L.r"}},
      {"ray-plane-dot", "case = hit and t > 0", {"L.r"}},
      {"ray-plane-dot", "t = 1", {"L.r", "L.Q"}},
      {"ray-plane-dot", "t = 2", {"L.r"}},
      {"ray-plane-dot", "t < 0", {"L.r", "L.Q"}},
      {"ray-plane-dot", "case = parallel", {"L.r"}},
      {"ray-plane-dot", "case = in-plane", {"L.Q"}},
      {"ray-plane-dot", "case = hit", {"L.r"}},
      {"ray-plane-dot", "case = hit and denominator > 0 and t > 0", {"L.Q"}},
      {"ray-plane-picture", "D < 0", {"G.offset"}},
      {"ray-plane-picture", "denominator < 0", {"L.r"}},
      {"ray-plane-picture", "numerator = 0 and case = hit", {"L.Q"}},
      {"ray-plane-picture", "t = 1", {"L.r", "L.Q"}},
      {"ray-plane-picture", "t < 0", {"L.r", "L.Q"}},
      {"ray-plane-picture", "case = behind", {"L.r", "L.Q"}},
      {"ray-plane-picture", "case = parallel", {"L.r"}},
      {"ray-plane-picture", "case = in-plane", {"L.Q"}},
      {"ray-plane-picture", "length_n > 2", {"G.n"}},
      {"ray-plane-picture", "case = hit and normal = kept", {"G.n"}},
      {"reflection", "points = level", {"E.n"}},
      {"reflection", "brightness = 1 and case = hit", {"L.r"}},
      {"reflection", "case = hit and dot > 0", {"E.n"}},
      {"reflection", "turn = 0 and case = hit", {"L.r"}},
      {"reflection", "brightness = 1/3 and case = hit", {"L.r"}},
      {"reflection", "case = behind", {"L.r"}},
      {"shadow", "part = 1/2", {"A"}},
      {"shadow", "t_A = 0", {"A"}},
      {"shadow", "facing = 0 and sun_shadow = flat", {"r.v"}},
      {"shadow", "t_M = 0 and t_A != 0", {"B"}},
      {"shadow", "k_A = 2", {"Q"}},
      {"shadow", "ratio = 1/2 and k_A >= 1 and k_B >= 1", {"B"}},
      {"shadow", "lamp_A = away", {"A"}},
      {"shadow", "ahead_A = 0 and lamp_A = parallel", {"A"}},
      {"shadow", "sun_A = plane-first and k_A > 0 and k_A < 1", {"A"}},
      {"closest-points", "back = start", {"g.A"}},
      {"closest-points", "gh = 0", {"h.v"}},
      {"closest-points", "s > 2", {"h.v"}},
      {"closest-points", "case = meet", {"h.A"}},
      {"closest-points", "distance = 2", {"h.A"}},
      {"closest-points", "hh > 36", {"h.v"}},
      {"closest-points", "case = parallel", {"h.v"}},
      {"closest-points", "case = coincident", {"h.A"}},
      {"camera", "case = beside", {"X"}},
      {"camera", "column = 0 and row = 0", {"X"}},
      {"camera", "through = yes", {"X"}},
      {"camera", "k = 1", {"X"}},
      {"camera", "p = 2 and case = seen", {"X"}},
      {"camera", "k = 1/2 and case = seen", {"X"}},
      {"camera", "case = behind", {"X"}},
      {"camera", "case = level", {"X"}},
      {"clipping", "corners = 3 and f_C < 0", {"C"}},
      {"clipping", "t1 = 1/2", {"B"}},
      {"clipping", "nn > 49", {"E.n"}},
      {"clipping", "edge1 = enters", {"E.n"}},
      {"clipping", "edge1 = outside and case = cut", {"A"}},
      {"clipping", "corners = 3 and case = cut", {"E.offset"}},
      {"clipping", "f_B = 0 and case = whole", {"B"}},
      {"clipping", "case = touch and corners = 1", {"E.offset"}},
      {"clipping", "case = whole", {"E.offset"}},
      {"ray-triangle-perp", "case = miss", {"L.Q", "L.r"}},
      {"ray-triangle-perp", "case = hit and location = edge", {"L.Q", "L.r"}},
      {"ray-triangle-perp", "case = hit and location = vertex", {"L.Q", "L.r"}},
      {"ray-triangle-perp", "case = collinear", {"T.P0", "T.P1", "T.P2"}},
      {"photon-torpedo", "nearest >= 3 and nearest <= 18", {"U.g"}},
      {"photon-torpedo", "nearest.lambda > 2", {}}, // by the number l
      {"photon-torpedo", "nearest.case = miss and behind > 0", {"U.g"}},
      {"photon-torpedo", "chosen.case = miss and perp.t > 0", {}}, // by a click on a row
      {"photon-torpedo", "so_far_is_nearest = yes", {}},           // likewise
      {"photon-torpedo", "ties >= 2", {"U.g"}},
      {"photon-torpedo", "chosen.case = parallel", {"U.g"}},
      {"photon-torpedo", "nearest >= 23 and nearest <= 24", {"wall.P"}},
      {"photon-torpedo", "nearest <= 2", {"U.g", "U.S"}},
      {"triangle-degenerate", "test_u = yes", {"T.P1"}},
      {"triangle-degenerate", "same_corners = P1-P2", {"T.P1"}},
      {"triangle-degenerate", "same_corners = P1-P2 and denominator = 0", {"T.P2"}},
      {"triangle-degenerate", "case = collinear and cos_angle = -1", {"T.P1"}},
      {"triangle-degenerate", "case = collinear and test_cosine = yes", {"T.P1"}},
      {"triangle-degenerate", "test_cosine = undefined", {"T.P1"}},
      {"triangle-degenerate", "case = proper", {"T.P1"}},
      {"triangle-degenerate", "denominator < -100", {"T.P1"}},
      {"ray-sphere", "contacts = none", {"L.Q"}},
      {"ray-sphere", "contacts = tangent", {"L.Q"}},
      {"ray-sphere", "distance = 0", {"L.Q", "L.r"}},
      {"ray-sphere", "distance = 4", {"L.Q"}},
      {"ray-sphere", "origin = inside", {"L.Q"}},
      {"ray-sphere", "origin = on", {"L.Q"}},
      {"ray-sphere", "case = behind", {"L.Q"}},
      {"ray-box-slabs", "x.in = 2", {"L.Q"}},
      {"ray-box-slabs", "z.first = low", {"L.r"}},
      {"ray-box-slabs", "case = miss and t_in > 0", {"L.Q"}},
      {"ray-box-slabs", "contacts = one", {"L.Q"}},
      {"ray-box-slabs", "origin = inside", {"L.Q"}},
      {"ray-box-slabs", "case = hit and t_in > 0 and face_in = z-high", {"L.Q"}},
      {"ray-box-slabs", "x.way != crossed", {"L.r"}},
      {"ray-box-slabs", "case = hit and x.way = within", {"L.Q"}},
      {"barycentric", "case = outside and barycentric.0 < 0", {"Q"}},
      {"barycentric", "barycentric.0 = 1/3 and barycentric.1 = 1/3", {"Q"}},
      {"barycentric", "area < 30 and area > 0", {"T.P0", "T.P1", "T.P2"}},
      {"barycentric", "barycentric.0 = 1/2", {"Q"}},
      {"barycentric", "barycentric.0 = 1/2 and case = edge", {"Q"}},
      {"barycentric", "case = vertex", {"Q"}},
      {"barycentric", "barycentric.0 < 0 and barycentric.1 < 0", {"Q"}},
      {"ray-triangle-cramer", "location = outside", {"L.Q", "L.r"}},
      {"ray-triangle-cramer", "barycentric.1 = 1", {"L.Q"}},
      {"ray-triangle-cramer", "case = hit", {"L.Q", "L.r"}},
      {"ray-triangle-cramer", "case = parallel", {"L.r"}},
      {"plane-plane", "case = parallel", {"E.n"}},
      {"plane-plane", "case = coincident", {"E.offset", "E.P0"}},
      {"plane-plane", "case = line and cos_angle = 0", {"E.n", "F.n"}},
      {"point-line", "t = 0", {"Q"}},
      {"point-line", "t < 0", {"Q"}},
      {"point-line", "case = on", {"Q"}},
      {"point-line", "distance = 3", {"Q"}},
      {"pluecker-lines", "six.through_origin = true", {"g.A"}},
      {"pluecker-lines", "six.origin_distance = 3", {"g.A"}},
      {"pluecker-lines", "pair.tetrahedron = 2", {"h.A"}},
      {"pluecker-lines", "pair.product < 0", {"h.A", "h.v"}},
      {"pluecker-lines", "pair.case = intersecting and pair.product = 0", {"h.A"}},
      {"pluecker-lines", "pair.distance = 1", {"h.A"}},
      {"pluecker-lines", "pair.perpendicular = true", {"h.v"}},
      {"pluecker-lines", "pair.case = parallel", {"h.v"}},
      {"pluecker-planes", "cut.point.2 = 3", {"G.offset"}},
      {"pluecker-planes", "cut.case = point and cut.homogeneous.3 = 1", {"G.n"}},
      {"pluecker-planes", "cut.case = parallel and cut.homogeneous.3 = 0", {"G.n"}},
      {"pluecker-planes",
       "cut.case = in-plane and cut.homogeneous.0 = 0 and cut.homogeneous.1 = 0 and cut.homogeneous.2 = 0",
       {"G.offset", "G.P0"}},
      {"ray-polygon-pluecker", "case = miss", {"L.Q", "L.r"}},
      {"ray-polygon-pluecker", "case = hit and location = edge", {"L.Q", "L.r"}},
      {"ray-polygon-pluecker", "case = miss and products.0 = 0", {"L.Q", "L.r"}},
      {"ray-polygon-pluecker", "case = hit and location = vertex", {"L.Q", "L.r"}},
      {"ray-polygon-pluecker", "case = behind", {"L.r"}},
      {"ray-polygon-pluecker", "case = parallel", {"L.r"}},
      {"ray-polygon-pluecker", "case = not-convex", {"W.P2"}},
      {"ray-triangle-pluecker", "barycentric.0 < 0", {"L.Q", "L.r"}},
      {"ray-triangle-pluecker", "case = hit and barycentric.1 = 1/2", {"L.Q", "L.r"}},
      {"ray-triangle-pluecker", "case = hit and location = vertex", {"L.Q", "L.r"}},
      {"ray-solid-pluecker", "products.8 < 0", {"L.Q"}},
      {"ray-solid-pluecker", "case = hit and left.face = 3", {"L.r"}},
      {"ray-solid-pluecker", "case = hit and left.face = 0", {"L.r"}},
      {"ray-solid-pluecker", "case = miss", {"K.a", "K.c"}},
      {"ray-solid-pluecker", "entered.point.z = 3", {"L.Q"}},
      {"ray-solid-pluecker", "case = hit and left.face = 5", {"L.Q"}},
      {"ray-solid-pluecker", "origin = inside", {"L.Q"}},
      {"ray-solid-pluecker", "case = behind", {"L.Q"}},
      {"ray-solid-pluecker", "case = hit and contacts = two and entered.location = edge", {"L.Q", "L.r"}},
      {"ray-solid-pluecker", "case = hit and entered.location = vertex", {"L.Q", "L.r"}},
      {"ray-solid-pluecker", "case = flat", {"K.c"}},
      {"ray-prism-pluecker", "case = hit and left.face = 2", {"L.r"}},
      {"ray-prism-pluecker", "case = hit and left.face = 3", {"L.r"}},
      {"ray-prism-pluecker", "case = flat", {"K.h"}},
      {"ray-prism-pluecker", "case = not-convex", {"K.P2"}},
      {"three-methods", "case = behind", {"L.Q"}},
      {"three-methods", "case = parallel", {"L.r"}},
      {"three-methods", "case = in-plane", {"L.Q"}},
      {"three-methods", "case = collinear", {"T.P0", "T.P1", "T.P2"}},
      {"misprints", "distance = fails", {"L.Q"}},
      {"misprints", "triple = fails", {"T.P0", "T.P1", "T.P2"}},
      {"misprints", "cosine = fails", {"T.P0"}},
      {"misprints", "perimeter = fails", {"L.Q", "L.r"}},
      {"misprints", "vertex = fails", {"L.Q", "L.r"}},
      {"misprints", "facing = fails", {"L.r"}},
      {"misprints", "direction = fails", {"T.P1"}},
      {"misprints", "start = fails", {"L.r"}},
      {"cross-product", "points = down", {"v.v"}},
      {"cross-product", "cross.0 = 0 and case = proper", {"v.v"}},
      {"cross-product", "parallelogram = 9", {"v.v"}},
      {"cross-product", "parallelogram = 9 and length_v > 5", {"v.v"}},
      {"cross-product", "uv = 0 and case = proper", {"v.v"}},
      {"cross-product", "case = same-direction", {"v.v"}},
      {"cross-product", "case = opposite", {"v.v"}},
      {"cross-product", "length = 3", {"v.v"}},
      {"cross-product", "triangle = 9/2 and uv = 0", {"v.v"}},
  };
  return table;
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
    progress.observe(tasksOf(step), evaluation);
    if (progress.done()[task])
      scene = now;
  }
};

/// One drag of a handle while a task is to be done.
class TaskDrag {
public:
  TaskDrag(Doing &doing, const std::string &id)
      : m_doing(doing), m_before(doing.scene), m_dragged(handle(doing.scene, id)),
        m_evaluation(evaluate(m_before)), m_drag(press()) {
    m_doing.observe(m_before, m_evaluation);
  }

  /// All over the view, line by line, coarsely at first: so the pointer comes near every place. What cannot
  /// be reached so can be with Shift held for a while.
  bool succeeds() {
    if (sweep())
      return true;
    for (double y = 0; y < viewSize.height && !isOwn(m_drag.mode()); y += coarseSpacing) {
      m_drag = press();
      m_drag.setMode(DragMode::Vertical);
      if (moveTo({m_pressed.x, y}))
        return true;
      m_drag.setMode(DragMode::Horizontal);
      if (sweep())
        return true;
    }
    return false;
  }

private:
  HandleDrag press() {
    m_pressed = glm::dvec2(m_view.camera.project(shownPlace(m_dragged), m_view.size).value());
    return {m_before, m_dragged, grabMode(m_dragged, false, m_view.camera).value(), m_pressed,
            taskTargets(tasksOf(m_doing.step), m_before, m_dragged)};
  }

  static constexpr double coarseSpacing = 4 * catchDistance;

  bool sweep() {
    for (const double spacing : {coarseSpacing, catchDistance})
      for (double y = 0; y < viewSize.height; y += spacing)
        for (double x = 0; x < viewSize.width; x += spacing)
          if (moveTo({x, y}))
            return true;
    return false;
  }

  bool moveTo(glm::dvec2 pixel) {
    const auto move = m_drag.moveTo(pixel, usualStep, m_view);
    if (!move)
      return false;
    Scene now = m_before;
    setObject(now, m_dragged.object, move->object);
    m_evaluation = evaluate(now, m_evaluation);
    m_doing.observe(now, m_evaluation);
    return m_doing.progress.done()[m_doing.task];
  }

  Doing &m_doing;
  View m_view{homeView(m_doing.lesson.camera, figureOf(evaluate(m_doing.lesson.scene)), true, viewSize, 1),
              viewSize, 1};
  Scene m_before;
  Handle m_dragged;
  Evaluation m_evaluation;
  glm::dvec2 m_pressed{};
  HandleDrag m_drag;
};

TEST(DragsForTasks, OfEveryTask_IsSaidInTheTable) {
  std::size_t tasks = 0;
  for (const Lesson &lesson : readLessons(LESSON_FOLDER).lessons)
    for (const LessonStep &step : lesson.steps)
      for (const Task &task : tasksOf(step)) {
        ++tasks;
        EXPECT_TRUE(rowOf(lesson, task)) << lesson.id << ": " << task.instruction.written();
      }
  EXPECT_GT(tasks, 0U);
}

/// A step's tasks one after the other, each with every handle that it names; the first of them leads on.
void doTasksOf(const Lesson &lesson, const LessonStep &step) {
  Scene scene = lesson.scene;
  TaskProgress progress;
  const std::vector<Task> tasks = tasksOf(step);
  for (std::size_t task = 0; task < tasks.size(); ++task) {
    const Asked *asked = rowOf(lesson, tasks[task]);
    ASSERT_TRUE(asked) << tasks[task].instruction.written();
    const Doing start{lesson, step, task, scene, progress};
    for (const std::string &id : asked->handles) {
      Doing doing = start;
      EXPECT_TRUE(TaskDrag(doing, id).succeeds())
          << lesson.id << ": " << tasks[task].instruction.written() << " with " << id;
      if (id == asked->handles.front()) {
        scene = doing.scene;
        progress = doing.progress;
      }
    }
  }
}

TEST(DragsForTasks, OfEveryHandleThatATaskNames_DoesIt) {
  const LessonLibrary library = readLessons(LESSON_FOLDER);
  std::vector<std::pair<const Lesson *, const LessonStep *>> steps;
  for (const Lesson &lesson : library.lessons)
    for (const LessonStep &step : lesson.steps)
      if (!tasksOf(step).empty())
        steps.emplace_back(&lesson, &step);
  for (const auto &[lesson, step] : test::fewer(steps))
    doTasksOf(*lesson, *step);
}

} // namespace
} // namespace halfspace
