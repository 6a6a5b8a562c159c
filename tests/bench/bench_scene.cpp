// Scenes that grow: what an edit, a frame of a drag, saving and opening, what fits a selection and holds of
// it, and the completions of a typed line cost in scenes of 3 to 500 constructions, and the list of 5, 20 and
// 1,000 lessons. Each should be flat or linear.
#include "lessons/discovery/discover.h"
#include "lessons/fitting/fits.h"
#include "lessons/lesson/lesson.h"
#include "lessons/lesson/shown.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "lessons/scene/file/session_file.h"
#include "lessons/scene/hand/snap_targets.h"
#include "lessons/scene/history.h"
#include "lessons/typed/complete_line.h"
#include "tests/bench/durations.h"
#include "widgets/picture/stage.h"

#include <cstdio>
#include <filesystem>
#include <fstream>

namespace halfspace::bench {
namespace {

/// Four distances for each plane and point, every tenth of them that of an earlier foot.
Scene sceneOf(int constructions) {
  Scene scene;
  for (int i = 0; i < constructions; ++i) {
    const std::string group = std::to_string(i / 4);
    if (i % 4 == 0) {
      scene.entries.push_back({"E" + group, PlaneObject{{i % 7, 4, 7}, {1, 2, 1 + i % 3}}});
      scene.entries.push_back({"Q" + group, PointObject{{i % 11, i % 13, 8}}});
    }
    const std::string point = i % 10 == 9 ? "d" + std::to_string(i - 1) + ".F" : "Q" + group;
    scene.entries.push_back(
        {"d" + std::to_string(i), ConstructionUse{"signed-distance", {{"E", "E" + group}, {"Q", point}}}});
  }
  return scene;
}

/// The median of some times.
template <class Work> double millisecondsOf(int times, Work work) {
  Durations durations;
  for (int i = 0; i < times; ++i) {
    const auto start = Clock::now();
    work(i);
    durations.add(millisecondsSince(start));
  }
  return durations.median();
}

/// A step that shows one of the lines.
LessonStep stepOfOneLine() {
  LessonStep step;
  step.blocks = {StepLines{{"d0.f"}}};
  return step;
}

/// What a window does below its widgets in a frame of a drag: from the move to the figure on its stage and
/// the handles.
class Drag {
public:
  explicit Drag(const Scene &scene) : m_history({"bench", 0, scene}), m_evaluation(evaluate(scene)) {
    m_held = m_history.beginGesture("Move Q0");
    frame(-1);
  }

  void frame(int i) {
    m_history.moveGesture(m_held, ChangeObject{"Q0", PointObject{{i, 2, 3}}});
    const Scene &scene = m_history.session().scene;
    m_evaluation = evaluate(scene, m_evaluation);
    m_shown = shownIn(m_step, m_evaluation);
    m_figure = toStage(m_shown.figure, Stage());
    m_handles = handlesOf({scene, m_evaluation});
    m_moved = m_history.movedByGesture();
  }

  /// What the hand does when it takes hold of another handle.
  void press() const { (void)snapTargets({m_history.session().scene, m_evaluation}, m_handles.front()); }

private:
  LessonStep m_step = stepOfOneLine();
  History m_history;
  Evaluation m_evaluation;
  GestureToken m_held = GestureToken::Nobodys;
  Shown m_shown;
  Figure m_figure;
  std::vector<Handle> m_handles;
  std::vector<std::string> m_moved;
};

void measureScene(int constructions) {
  Scene scene = sceneOf(constructions);
  Evaluation evaluation = evaluate(scene);
  const auto edit = [&](int i) {
    const Edit move = ChangeObject{"Q0", PointObject{{i, 2, 3}}};
    scene = *apply(std::move(scene), move);
    evaluation = evaluate(scene, evaluation);
  };
  const double edited = millisecondsOf(50, edit);
  const double looked = millisecondsOf(20, [&](int i) {
    edit(i);
    (void)shownIn(stepOfOneLine(), evaluation);
  });
  Drag drag(scene);
  const double dragged = millisecondsOf(50, [&](int i) { drag.frame(i); });
  const double pressed = millisecondsOf(20, [&](int) { drag.press(); });
  const double anew = millisecondsOf(5, [&](int) { (void)figureOf(evaluate(scene)); });
  const Session session{"bench", 0, scene};
  std::string text;
  const double saved = millisecondsOf(10, [&](int) { text = writeSession(session); });
  const double opened = millisecondsOf(10, [&](int) { (void)readSession(text, "bench"); });
  std::printf(
      "%5zu entries: edit %7.3f ms, edit and look %7.3f ms, frame of a drag %7.3f ms, press %7.3f ms, "
      "all anew %7.3f ms, save %7.3f ms, open %7.3f ms\n",
      scene.entries.size(), edited, looked, dragged, pressed, anew, saved, opened);
}

/// What the window asks when something is selected.
void measureFits(int constructions) {
  const Scene scene = sceneOf(constructions);
  std::size_t found = 0;
  const double listed = millisecondsOf(50, [&](int) {
    found = fitsFor(scene, {"Q0", "d0.F", "d2.F"}).size();
  });
  const Evaluation evaluation = evaluate(scene);
  const double discovered = millisecondsOf(20, [&](int) {
    (void)discoveriesOf(evaluation, {"Q0", "d0.F", "E0"});
  });
  std::printf(
      "%5zu entries: the %zu fits of a point listed in %7.3f ms, what holds of a foot found in %7.3f ms\n",
      scene.entries.size(), found, listed, discovered);
}

/// What a key costs in a line that is being typed: at its begin, and between brackets.
void measureCompletions(int constructions) {
  const Scene scene = sceneOf(constructions);
  const auto completed = [&](const std::string &line) {
    return millisecondsOf(20, [&](int) { (void)completionsOf(line, line.size(), scene); });
  };
  std::printf("%5zu entries: completed an empty line %7.3f ms, a word %7.3f ms, an argument %7.3f ms\n",
              scene.entries.size(), completed(""), completed("dist"), completed("n = distance(E0, "));
}

void measureLessons(int count) {
  const auto folder = std::filesystem::temp_directory_path() / "halfspace-bench-lessons";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  for (int i = 0; i < count; ++i)
    std::ofstream(folder / (std::to_string(i) + ".md"))
        << "---\nid: lesson-" << i << "\ntitle: Lesson\norder: " << i
        << "\nscene:\n  - {name: Q, point: [1, 2, 3]}\n---\n## A step\nWords with $f(Q)$.\n";
  const double listed = millisecondsOf(3, [&](int) {
    if (readLessons(folder).lessons.size() != static_cast<std::size_t>(count))
      std::puts("lessons are missing");
  });
  std::printf("%5d lessons: listed in %8.3f ms\n", count, listed);
  std::filesystem::remove_all(folder);
}

} // namespace
} // namespace halfspace::bench

int main() {
  using namespace halfspace::bench;
  for (const int constructions : {3, 10, 100, 333, 500})
    measureScene(constructions);
  for (const int constructions : {6, 66, 333})
    measureFits(constructions);
  for (const int constructions : {6, 66, 333})
    measureCompletions(constructions);
  for (const int lessons : {5, 20, 1000})
    measureLessons(lessons);
}
