// A torpedo's flight, from its first frame to its last.
#include "lessons/lesson/step_of_flight.h"
#include "lessons/words.h"
#include "widgets/animation/staged_scene.h"
#include "widgets/flight/scene_flight.h"

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

/// Labels stay where they are at the beginning.
class Flight : public Motion {
public:
  Flight(StagedScene staged, const LessonStep &shown, SceneFlight flight, std::optional<double> seconds)
      : m_staged(std::move(staged)), m_step(shown), m_flight(std::move(flight)), m_camera(m_staged.camera()) {
    goTo(m_flight.frame.from);
    m_beginning = m_staged.content(&m_step);
    m_last = roundUpToMultiple(m_flight.lastFrame(m_staged.evaluation), 1);
    m_seconds = seconds.value_or(std::max(1.0, frames()) / framesPerSecond);
  }

  [[nodiscard]] double seconds() const override { return m_seconds; }

  [[nodiscard]] Moment at(double time) override {
    goTo(m_flight.frame.from + roundToMultiple(frames() * time / m_seconds, frameStep));
    return {m_staged.content(&m_step), m_beginning, m_camera};
  }

private:
  [[nodiscard]] double frames() const { return toDouble(m_last - m_flight.frame.from); }

  void goTo(const Rational &frame) {
    Scene &scene = m_staged.animated.scene;
    if (auto changed = halfspace::apply(scene, m_flight.toFrame(frame)))
      scene = std::move(*changed);
    m_staged.evaluation = evaluate(scene, m_staged.evaluation);
  }

  StagedScene m_staged;
  const LessonStep &m_step;
  SceneFlight m_flight;
  Camera m_camera;
  SceneContent m_beginning;
  Rational m_last; ///< a whole frame, as all are that are seen at the flight's own speed
  double m_seconds = 0;
};

Result<std::unique_ptr<Motion>> makeFlight(const AnimatedScene &scene, std::optional<double> seconds) {
  StagedScene staged(scene);
  const LessonStep *step = scene.lesson ? stepOfFlight(*scene.lesson) : nullptr;
  auto flight = step ? flightIn(scene.scene, *flightOf(*step)) : std::nullopt;
  if (!flight)
    return Problem{words("This lesson has no flight that could be shown in motion."), "", 0, "--motion"};
  const LessonStep &shown = staged.step() ? *staged.step() : *step;
  return std::unique_ptr<Motion>(
      std::make_unique<Flight>(std::move(staged), shown, std::move(*flight), seconds));
}

} // namespace

MotionKind flight() { return {"flight", words("The flight of the torpedo"), true, makeFlight}; }

} // namespace halfspace
