#include "app/batch/flight_frame.h"

#include "lessons/lesson/step_of_flight.h"
#include "lessons/words.h"
#include "widgets/flight/scene_flight.h"

#include <string>
#include <utility>

namespace halfspace {
namespace {

/// The flight as the scene has it; nothing where the lesson has none, or its number is gone from the scene.
std::optional<SceneFlight> flightOf(const OpenedSession &opened) {
  const LessonStep *step = stepOfFlight(opened);
  return step ? flightIn(opened.session.scene, *flightOf(*step)) : std::nullopt;
}

/// Puts the scene at the frame that is nearest, and returns that.
Rational goTo(const Rational &wanted, const SceneFlight &flight, Scene &scene) {
  const ChangeObject change = flight.toFrame(wanted);
  setObject(scene, change.name, change.value);
  return objectAs<NumberObject>(change.value)->value;
}

} // namespace

const LessonStep *stepOfFlight(const OpenedSession &opened) {
  return opened.lesson ? stepOfFlight(*opened.lesson) : nullptr;
}

void goToFirstFrame(OpenedSession &opened) {
  if (const auto flight = flightOf(opened))
    goTo(flight->frame.from, *flight, opened.session.scene);
}

std::optional<Problem> goToFrame(int wanted, OpenedSession &opened) {
  const auto flight = flightOf(opened);
  if (!flight)
    return Problem{words("This lesson has no flight whose frames could be drawn."), "", 0, "--frame"};
  const Rational nearest = goTo(wanted, *flight, opened.session.scene);
  if (nearest == wanted)
    return {};
  return Problem{words("The flight has no frame {frame}: the nearest is {nearest}.",
                       {{"frame", std::to_string(wanted)}, {"nearest", toText(nearest)}}),
                 "", 0, "--frame"};
}

} // namespace halfspace
