// A lesson's steps one after the other, as the window turns to them.
#include "lessons/figure/added_marks.h"
#include "lessons/words.h"
#include "widgets/animation/staged_scene.h"
#include "widgets/view/mark_fade.h"

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

/// Long enough to see what is new, in seconds.
constexpr double usualSecondsAStep = 2;

constexpr double millisecondsPerSecond = 1000;

/// How much of something that takes its time is done, from 0 to 1.
double partOf(double seconds, int milliseconds) {
  return std::clamp(seconds * millisecondsPerSecond / milliseconds, 0.0, 1.0);
}

/// All marks of all steps, each once: where labels stand beside all others.
SceneContent together(const std::vector<SceneContent> &steps) {
  SceneContent all = steps.front();
  for (const SceneContent &step : steps) {
    const std::set<std::string> added = idsAdded(all.figure, step.figure);
    for (const Mark &mark : step.figure.marks)
      if (added.contains(baseOf(mark).id))
        all.figure.marks.push_back(mark);
  }
  return all;
}

class Steps : public Motion {
public:
  Steps(const StagedScene &staged, std::optional<double> seconds) : m_camera(staged.camera()) {
    for (const LessonStep &step : staged.animated.lesson->steps)
      m_steps.push_back(staged.content(&step));
    m_labelled = together(m_steps);
    m_secondsAStep = seconds ? *seconds / static_cast<double>(m_steps.size()) : usualSecondsAStep;
  }

  [[nodiscard]] double seconds() const override {
    return m_secondsAStep * static_cast<double>(m_steps.size());
  }

  [[nodiscard]] Moment at(double time) override {
    const std::size_t step = std::min(static_cast<std::size_t>(time / m_secondsAStep), m_steps.size() - 1);
    const double since = time - static_cast<double>(step) * m_secondsAStep;
    return {step == 0 ? m_steps[0] : arriving(m_steps[step - 1], m_steps[step], since), m_labelled, m_camera};
  }

private:
  /// So many seconds after it has come in the place of another, new marks fade in. All else is as it was: it
  /// is one scene.
  [[nodiscard]] static SceneContent arriving(const SceneContent &before, SceneContent content, double since) {
    const double faded = partOf(since, MarkFade::fadeTime);
    if (faded < 1)
      content.arrival = {idsAdded(before.figure, content.figure), faded};
    return content;
  }

  Camera m_camera;
  std::vector<SceneContent> m_steps;
  SceneContent m_labelled;
  double m_secondsAStep;
};

Result<std::unique_ptr<Motion>> makeSteps(const AnimatedScene &scene, std::optional<double> seconds) {
  if (!scene.lesson || scene.lesson->steps.empty())
    return Problem{words("This scene is of no lesson that has steps."), "", 0, "--motion"};
  if (scene.step)
    return Problem{words("All steps are shown, one after the other: none can be chosen."), "", 0, "--step"};
  return std::unique_ptr<Motion>(std::make_unique<Steps>(StagedScene(scene), seconds));
}

} // namespace

MotionKind steps() { return {"steps", words("The steps of the lesson"), true, makeSteps}; }

} // namespace halfspace
